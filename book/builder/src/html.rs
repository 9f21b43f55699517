//! What a written page refers to and what it can be referred to by.

use html5ever::tendril::StrTendril;
use html5ever::tokenizer::{
    BufferQueue, Tag, TagKind, Token, TokenSink, TokenSinkResult, Tokenizer, TokenizerOpts,
    states::RawKind,
};
use std::cell::RefCell;
use std::collections::HashSet;

/// The identifiers and references of a page.
#[derive(Debug, Default)]
pub struct Document {
    /// Every `id`.
    pub ids: HashSet<String>,
    /// Identifiers that stand twice.
    pub doubles: Vec<String>,
    /// Addresses that a reader may follow.
    pub links: Vec<String>,
    /// Addresses that the browser loads by itself.
    pub resources: Vec<String>,
}

#[derive(Default)]
struct Sink(RefCell<Document>);

impl TokenSink for Sink {
    type Handle = ();

    fn process_token(&self, token: Token, _line: u64) -> TokenSinkResult<()> {
        if let Token::TagToken(tag) = token
            && tag.kind == TagKind::StartTag
        {
            self.0.borrow_mut().note(&tag);
            match &*tag.name {
                "script" => return TokenSinkResult::RawData(RawKind::ScriptData),
                "style" => return TokenSinkResult::RawData(RawKind::Rawtext),
                _ => {}
            }
        }
        TokenSinkResult::Continue
    }
}

impl Document {
    /// Reads a page.
    #[must_use]
    pub fn read(html: &str) -> Self {
        let queue = BufferQueue::default();
        queue.push_back(StrTendril::from(html));
        let tokenizer = Tokenizer::new(Sink::default(), TokenizerOpts::default());
        let _ = tokenizer.feed(&queue);
        tokenizer.end();
        tokenizer.sink.0.into_inner()
    }

    fn note(&mut self, tag: &Tag) {
        for attribute in &tag.attrs {
            let value = attribute.value.to_string();
            match (&*attribute.name.local, &*tag.name) {
                ("id", _) if !self.ids.insert(value.clone()) => self.doubles.push(value),
                ("href", "a") => self.links.push(value),
                ("href", "link") | ("src" | "srcset", _) => self.resources.push(value),
                _ => {}
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_is_read() {
        let page = Document::read(
            "<a id='x' href='b.html#y'>b</a><img src=\"c.png\"><script>\"<a href='no'>\"</script><p id=x>",
        );
        assert!(page.ids.contains("x"));
        assert_eq!(page.doubles, ["x"]);
        assert_eq!(page.links, ["b.html#y"]);
        assert_eq!(page.resources, ["c.png"]);
    }
}
