//! The directives of a page, turned into Markdown and HTML.

use crate::directive::Directive;
use crate::indexes;
use crate::markdown::{self, Edit, escape, fenced};
use crate::material::Material;
use crate::page::Page;
use crate::problem::{Place, Problems};
use crate::sections;
use crate::survey::Survey;
use crate::theorem::{Kind, Theorem, Topic};
use facette_figure::Content;
use std::fmt::Write as _;

/// Expands pages.
pub struct Expander<'a> {
    /// What the book is made of.
    pub material: &'a mut Material,
    /// All pages.
    pub pages: &'a [Page],
    /// What they cite.
    pub survey: &'a Survey,
    /// What is wrong.
    pub problems: &'a mut Problems,
    remark: usize,
}

/// What a figure's place holds until the page is written: mdBook neither parses nor indexes the drawing.
#[must_use]
pub fn figure_mark(path: &str) -> String {
    format!("<!--facette figure {path}-->")
}

impl<'a> Expander<'a> {
    /// An expander of all `pages`.
    pub fn new(
        material: &'a mut Material,
        pages: &'a [Page],
        survey: &'a Survey,
        problems: &'a mut Problems,
    ) -> Self {
        Expander {
            material,
            pages,
            survey,
            problems,
            remark: 0,
        }
    }

    /// The page's Markdown with directives and formulas replaced; mdBook's includes stay.
    pub fn page(&mut self, index: usize) -> String {
        let page = &self.pages[index];
        let place = Place::new(&page.file, 1);
        let survey = self.survey;
        let mut edits = self.material.maths.edits(&page.text, place, self.problems);
        for found in &survey.readings[index].directives {
            let line = place.line(&page.text, found.range.start);
            if let Ok(directive) = &found.directive
                && let Some(text) = self.directive(directive, page, Place::new(&page.file, line))
            {
                edits.push((found.range.clone(), text));
            }
        }
        markdown::apply(&page.text, edits)
    }

    fn directive(
        &mut self,
        directive: &Directive,
        page: &Page,
        place: Place<'_>,
    ) -> Option<String> {
        match directive {
            Directive::Theorem(path) => self.statement(Kind::Theorem, path, page, place),
            Directive::HardCase(path) => self.statement(Kind::HardCase, path, page, place),
            Directive::Figure(path) => self.figure(path, page, place),
            Directive::Remark(text) => Some(self.remark(text)),
            Directive::EndRemark => Some("\n\n</aside>\n\n".to_owned()),
            Directive::Exercises(chapter) => sections::exercises(self, chapter, page, place),
            Directive::Speed(chapter, beginning) => {
                sections::speed(self, chapter, beginning.as_deref(), place)
            }
            Directive::TheoremIndex => Some(indexes::theorem_index(self, page)),
            Directive::Errata => Some(indexes::errata(self, page)),
            Directive::SlideMap => Some(indexes::slide_map(self, page)),
            Directive::Glossary => Some(indexes::glossary(self, page)),
            Directive::Bibliography => Some(indexes::bibliography(self, page)),
            Directive::Cite(..) | Directive::Api(_) => self.inline(directive, page, place),
            Directive::Include(_) => None,
        }
    }

    /// The directives that may also stand in statements and captions.
    fn inline(&mut self, directive: &Directive, page: &Page, place: Place<'_>) -> Option<String> {
        let text = match directive {
            Directive::Cite(key, part) => self.cite(key, part.as_deref(), page),
            Directive::Api(path) => self.api(path, page),
            _ => Err("only `cite` and `api` may stand here".to_owned()),
        };
        text.map_err(|message| self.problems.add(place.file, place.first_line, message))
            .ok()
    }

    fn cite(&mut self, key: &str, part: Option<&str>, page: &Page) -> Result<String, String> {
        let work = self.material.works.rows.iter().find(|w| w.key == key);
        let work = work.ok_or_else(|| {
            format!("unknown citation `{key}`: book/bibliography.toml has no entry with this key")
        })?;
        let home = self
            .survey
            .bibliography
            .map(|index| self.pages[index].html())
            .ok_or("a citation, but no page has `{{#bibliography}}`")?;
        self.material.cited.insert(key.to_owned());
        let part = part.map_or_else(String::new, |part| format!(", {part}"));
        let link = page.link(&format!("{home}#work-{key}"));
        Ok(format!("[{}{part}]({link})", work.label()))
    }

    fn api(&mut self, path: &str, page: &Page) -> Result<String, String> {
        let address = self.material.api.resolve(path).ok_or_else(|| {
            format!("the rustdoc of facette has no public item `{path}`: expected a path such as `coons::CoonsPatch`")
        })?;
        let start = if address.contains('#') { 2 } else { 1 };
        let skip = path.split("::").count().saturating_sub(start);
        let name = path.split("::").skip(skip).collect::<Vec<_>>().join("::");
        Ok(format!("[`{name}`]({})", page.link(&address)))
    }

    /// A piece of Markdown from elsewhere (a statement, a caption) as it stands in `page`.
    pub fn prose(&mut self, text: &str, page: &Page, place: Place<'_>) -> String {
        let mut edits: Vec<Edit> = self.material.maths.edits(text, place, self.problems);
        for found in crate::directive::find(text) {
            let line = Place::new(place.file, place.line(text, found.range.start));
            match &found.directive {
                Ok(directive) => {
                    if let Some(replacement) = self.inline(directive, page, line) {
                        edits.push((found.range, replacement));
                    }
                }
                Err(message) => self
                    .problems
                    .add(line.file, line.first_line, message.clone()),
            }
        }
        markdown::apply(text, edits)
    }

    fn statement(
        &mut self,
        kind: Kind,
        path: &str,
        page: &Page,
        place: Place<'_>,
    ) -> Option<String> {
        let Some(theorem) = self.material.theorem(kind, path).cloned() else {
            let message = format!(
                "no test proves `{path}`: expected a `#[test]` of this name in tests/{}/{}.rs",
                path.split("::").next().unwrap_or_default(),
                kind.stem()
            );
            self.problems.add(place.file, place.first_line, message);
            return None;
        };
        let number = self.survey.theorem(kind, path).map(|s| s.number.clone());
        let source = Place::new(&theorem.file, theorem.line);
        let title = self.prose(&theorem.title, page, source);
        let statement = self.prose(&theorem.statement, page, source);
        let mut text = format!(
            "\n\n<section class=\"{}\" id=\"{}\">\n<div class=\"box-title\">\n\n<span class=\"box-label\">{} {}</span> {title}\n\n</div>\n\n{}\n\n",
            kind.class(),
            theorem.anchor(),
            kind.label(),
            number.unwrap_or_default(),
            statement.trim(),
        );
        for erratum in &theorem.errata {
            let erratum = self.prose(erratum, page, source);
            let _ = write!(
                text,
                "<div class=\"erratum\">\n\n<span class=\"box-label\">Erratum</span> {erratum}\n\n</div>\n\n"
            );
        }
        text.push_str(&self.proof(&theorem, page));
        text.push_str("</section>\n\n");
        Some(text)
    }

    /// The folded part of a box: code, command, exercises, slides.
    fn proof(&self, theorem: &Theorem, page: &Page) -> String {
        let command = format!(
            "$ cargo test --test {} -- {}",
            theorem.chapter, theorem.name
        );
        let mut text = format!(
            "<details>\n<summary>The test that checks it</summary>\n\n{}\nRun it:\n\n{}\n",
            fenced("rust", &theorem.code),
            fenced("console", &command),
        );
        for name in &theorem.exercises {
            if let Some((list, exercise)) = self.material.exercise(&theorem.chapter, name) {
                let link = page.link(&format!("{}#exercise-{name}", list.page));
                let _ = write!(
                    text,
                    "It grades the exercise [{}]({link}).\n\n",
                    exercise.title
                );
            }
        }
        for topic in &theorem.topics {
            let _ = write!(
                text,
                "In the course: {} ({}), {}.\n\n",
                topic.slide, topic.id, topic.topic
            );
        }
        text.push_str("</details>\n");
        text
    }

    fn figure(&mut self, path: &str, page: &Page, place: Place<'_>) -> Option<String> {
        let Some(found) = self.material.figure(path).cloned() else {
            let message = format!(
                "no figure `{path}`: expected an entry of FIGURES in examples/{}.rs",
                path.split("::").next().unwrap_or_default()
            );
            self.problems.add(place.file, place.first_line, message);
            return None;
        };
        let figure = &found.figure;
        for (what, text) in [
            ("caption", &figure.caption),
            ("alternative text", &figure.alternative),
        ] {
            if text.trim().is_empty() {
                let message = format!("the figure `{path}` has no {what}");
                self.problems.add(place.file, place.first_line, message);
            }
        }
        let number = self.survey.figures.get(path)?.number.clone();
        let caption = self.prose(figure.caption.trim(), page, place);
        let content = match &figure.content {
            Content::Svg(_) => figure_mark(path),
            Content::Png(bytes) => self.picture(path, figure, bytes, page, place)?,
        };
        Some(format!(
            "\n\n<figure id=\"figure-{}\">\n{content}\n<figcaption>\n\n<span class=\"box-label\">Figure {number}</span> {caption}\n\n</figcaption>\n</figure>\n\n",
            path.replace("::", "-")
        ))
    }

    fn picture(
        &mut self,
        path: &str,
        figure: &facette_figure::Figure,
        bytes: &[u8],
        page: &Page,
        place: Place<'_>,
    ) -> Option<String> {
        let Some((width, height)) = crate::assets::png_size(bytes) else {
            let message = format!("the figure `{path}` is not a PNG file");
            self.problems.add(place.file, place.first_line, message);
            return None;
        };
        let address = page.link(&crate::assets::picture_path(path));
        Some(format!(
            "<img src=\"{address}\" alt=\"{}\" width=\"{width}\" height=\"{height}\">",
            escape(&one_line(&figure.alternative))
        ))
    }

    /// The beginning of a remark. The survey has counted the well-formed ones.
    fn remark(&mut self, text: &str) -> String {
        let remark = self.survey.remarks.get(self.remark);
        let (Ok(_), Some(remark)) = (Topic::parse(text), remark) else {
            return "\n\n<aside class=\"remark\">\n\n".to_owned();
        };
        self.remark += 1;
        let topic = &remark.topic;
        let id = &topic.id;
        let claim = if id.chars().any(|c| c.is_ascii_digit()) {
            format!(", {id}")
        } else {
            String::new()
        };
        format!(
            "\n\n<aside class=\"remark\" id=\"{}\">\n<div class=\"box-title\">\n\n<span class=\"box-label\">Remark</span> {} ({}{claim})\n\n</div>\n\n",
            remark.anchor, topic.topic, topic.slide
        )
    }
}

/// Text without line breaks.
#[must_use]
pub fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
