//! Hears what mdBook complains about: it logs a warning and ends with success.

use std::fmt::{self, Write as _};
use std::sync::{Arc, Mutex};
use tracing::field::{Field, Visit};
use tracing::{Event, Level, Subscriber};
use tracing_subscriber::layer::{Context, Layer, SubscriberExt};

/// Runs `work` and returns its result with the warnings and errors that were logged meanwhile.
pub fn hear<T>(work: impl FnOnce() -> T) -> (T, Vec<String>) {
    let heard = Arc::new(Mutex::new(Vec::new()));
    let subscriber = tracing_subscriber::registry().with(Ear(Arc::clone(&heard)));
    let result = tracing::subscriber::with_default(subscriber, work);
    let heard = heard.lock().map(|h| h.clone()).unwrap_or_default();
    (result, heard)
}

struct Ear(Arc<Mutex<Vec<String>>>);

impl<S: Subscriber> Layer<S> for Ear {
    fn on_event(&self, event: &Event<'_>, _: Context<'_, S>) {
        if *event.metadata().level() > Level::WARN {
            return;
        }
        let mut message = Message(String::new());
        event.record(&mut message);
        if let Ok(mut heard) = self.0.lock() {
            heard.push(message.0.split_whitespace().collect::<Vec<_>>().join(" "));
        }
    }
}

struct Message(String);

impl Visit for Message {
    fn record_debug(&mut self, field: &Field, value: &dyn fmt::Debug) {
        if field.name() == "message" {
            let _ = write!(self.0, "{value:?}");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn warnings_are_heard_and_news_are_not() {
        let (result, heard) = hear(|| {
            tracing::warn!("unclosed\n tag");
            tracing::info!("writing");
            7
        });
        assert_eq!(result, 7);
        assert_eq!(heard, ["unclosed tag"]);
    }
}
