//! Markdown with formulas, as plain text for a terminal.

use std::iter::Peekable;
use std::str::Chars;

/// The text without Markdown's marks, its formulas in Unicode: `**$S_1$** is $\frac{1}{2}$` becomes `S₁ is 1/2`.
///
/// What has no plain form keeps its LaTeX name without the backslash: nothing is lost.
#[must_use]
pub fn readable(markdown: &str) -> String {
    let mut text = String::new();
    for (index, part) in markdown.split('`').enumerate() {
        let is_code = index % 2 == 1;
        if is_code {
            text.push_str(part);
        } else {
            text.push_str(&prose(part));
        }
    }
    text
}

fn prose(part: &str) -> String {
    let marked = part.replace("$$", "$");
    let mut text = String::new();
    for (index, piece) in marked.split('$').enumerate() {
        let is_formula = index % 2 == 1;
        if is_formula {
            text.push_str(&formula(piece));
        } else {
            text.push_str(&piece.replace("**", ""));
        }
    }
    text
}

/// The paragraphs of the text, broken into lines of at most `width` characters where words allow it.
#[must_use]
pub fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for (index, paragraph) in text.split("\n\n").enumerate() {
        if index > 0 {
            lines.push(String::new());
        }
        let mut line = String::new();
        for word in paragraph.split_whitespace() {
            let length = line.chars().count() + 1 + word.chars().count();
            if !line.is_empty() && length > width {
                lines.push(std::mem::take(&mut line));
            }
            if !line.is_empty() {
                line.push(' ');
            }
            line.push_str(word);
        }
        lines.push(line);
    }
    lines
}

fn formula(latex: &str) -> String {
    Formula {
        letters: latex.chars().peekable(),
    }
    .up_to(None)
}

struct Formula<'a> {
    letters: Peekable<Chars<'a>>,
}

impl Formula<'_> {
    /// Everything up to the closing letter, or to the end.
    fn up_to(&mut self, closing: Option<char>) -> String {
        let mut text = String::new();
        while let Some(letter) = self.letters.next() {
            match letter {
                _ if Some(letter) == closing => break,
                '\\' => text.push_str(&self.command()),
                '{' => text.push_str(&self.up_to(Some('}'))),
                '_' => text.push_str(&script('_', &self.argument(), subscript)),
                '^' => text.push_str(&script('^', &self.argument(), superscript)),
                '&' | '}' => {}
                '~' => text.push(' '),
                '-' => text.push('−'),
                '\'' => text.push('′'),
                _ => text.push(letter),
            }
        }
        text
    }

    /// A group in braces, a command, or one letter.
    fn argument(&mut self) -> String {
        while self
            .letters
            .next_if(|letter| letter.is_whitespace())
            .is_some()
        {}
        match self.letters.next() {
            Some('{') => self.up_to(Some('}')),
            Some('\\') => self.command(),
            Some(letter) => letter.to_string(),
            None => String::new(),
        }
    }

    /// What a command stands for; its backslash has been read.
    fn command(&mut self) -> String {
        let mut name = String::new();
        while let Some(letter) = self.letters.next_if(char::is_ascii_alphabetic) {
            name.push(letter);
        }
        match name.as_str() {
            "" => self.single_letter_command(),
            "frac" | "tfrac" | "dfrac" => {
                let (above, below) = (self.argument(), self.argument());
                format!("{}/{}", grouped(&above), grouped(&below))
            }
            "sqrt" => format!("√{}", grouped(&self.argument())),
            "begin" | "end" => {
                self.argument();
                String::new()
            }
            "left" | "right" | "big" | "Big" | "bigl" | "bigr" | "Bigl" | "Bigr"
            | "displaystyle" => String::new(),
            _ => symbol(&name).map_or(name, str::to_owned),
        }
    }

    fn single_letter_command(&mut self) -> String {
        match self.letters.next() {
            Some('\\') => "; ".to_owned(),
            Some('!') | None => String::new(),
            Some(',' | ';' | ':' | ' ') => " ".to_owned(),
            Some('|') => "‖".to_owned(),
            Some(letter) => letter.to_string(),
        }
    }
}

/// In parentheses, unless it is one number or letter.
fn grouped(text: &str) -> String {
    let is_simple = text.chars().all(char::is_alphanumeric);
    if is_simple {
        text.to_owned()
    } else {
        format!("({text})")
    }
}

fn script(mark: char, text: &str, small: fn(char) -> Option<char>) -> String {
    let small_text: Option<String> = text.chars().map(small).collect();
    match small_text {
        Some(small_text) => small_text,
        None if text.chars().count() == 1 => format!("{mark}{text}"),
        None => format!("{mark}({text})"),
    }
}

fn subscript(letter: char) -> Option<char> {
    translated(letter, "0123456789ijuvtnm+−", "₀₁₂₃₄₅₆₇₈₉ᵢⱼᵤᵥₜₙₘ₊₋")
}

fn superscript(letter: char) -> Option<char> {
    translated(letter, "0123456789ijuvtnm+−′", "⁰¹²³⁴⁵⁶⁷⁸⁹ⁱʲᵘᵛᵗⁿᵐ⁺⁻′")
}

fn translated(letter: char, from: &str, to: &str) -> Option<char> {
    let position = from.chars().position(|candidate| candidate == letter)?;
    to.chars().nth(position)
}

const SYMBOLS: [(&str, &str); 58] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("varepsilon", "ε"),
    ("epsilon", "ε"),
    ("theta", "θ"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("pi", "π"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("varphi", "φ"),
    ("phi", "φ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Delta", "Δ"),
    ("Phi", "Φ"),
    ("Omega", "Ω"),
    ("sum", "Σ"),
    ("prod", "Π"),
    ("int", "∫"),
    ("partial", "∂"),
    ("nabla", "∇"),
    ("infty", "∞"),
    ("cdot", "·"),
    ("cdots", "…"),
    ("dots", "…"),
    ("ldots", "…"),
    ("times", "×"),
    ("oplus", "⊕"),
    ("circ", "∘"),
    ("pm", "±"),
    ("le", "≤"),
    ("leq", "≤"),
    ("ge", "≥"),
    ("geq", "≥"),
    ("ne", "≠"),
    ("neq", "≠"),
    ("approx", "≈"),
    ("equiv", "≡"),
    ("in", "∈"),
    ("notin", "∉"),
    ("subset", "⊂"),
    ("forall", "∀"),
    ("exists", "∃"),
    ("to", "→"),
    ("mapsto", "↦"),
    ("Rightarrow", "⇒"),
    ("iff", "⇔"),
    ("lvert", "|"),
    ("rvert", "|"),
    ("lVert", "‖"),
    ("rVert", "‖"),
    ("prime", "′"),
    ("ell", "ℓ"),
];

/// The names that only say how something looks.
const STYLES: [&str; 14] = [
    "text",
    "mathrm",
    "mathbf",
    "mathit",
    "mathcal",
    "mathbb",
    "operatorname",
    "vec",
    "hat",
    "bar",
    "tilde",
    "boldsymbol",
    "quad",
    "qquad",
];

fn symbol(name: &str) -> Option<&'static str> {
    match name {
        "quad" | "qquad" => Some("  "),
        _ if STYLES.contains(&name) => Some(""),
        _ => SYMBOLS
            .iter()
            .find(|(latex, _)| *latex == name)
            .map(|(_, plain)| *plain),
    }
}
