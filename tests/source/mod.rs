//! Reads Rust source as far as the tests of the laws need it.

#![allow(dead_code, reason = "not every test uses every function")]

use std::ops::Range;

#[derive(Clone, Debug, PartialEq)]
pub enum Token {
    Word(String),
    PathSeparator,
    Mark(char),
}

/// Returns the words and punctuation of Rust source, without comments, strings and character literals. Each token comes
/// with the place of its first character.
fn placed_tokens(text: &str) -> Vec<(usize, Token)> {
    let chars: Vec<char> = text.chars().collect();
    let starts_with = |at: usize, what: &str| what.chars().enumerate().all(|(k, c)| chars.get(at + k) == Some(&c));
    let mut tokens = Vec::new();
    let mut at = 0;
    while at < chars.len() {
        let c = chars[at];
        if starts_with(at, "//") {
            at += chars[at..].iter().take_while(|c| **c != '\n').count();
        } else if starts_with(at, "/*") {
            while at < chars.len() && !starts_with(at, "*/") {
                at += 1;
            }
            at += 2;
        } else if c == '"' {
            at += 1;
            while at < chars.len() && chars[at] != '"' {
                at += if chars[at] == '\\' { 2 } else { 1 };
            }
            at += 1;
        } else if c == 'r' && (starts_with(at, "r\"") || starts_with(at, "r#\"")) {
            let hashes = chars[at + 1..].iter().take_while(|c| **c == '#').count();
            let end = format!("\"{}", "#".repeat(hashes));
            at += hashes + 2;
            while at < chars.len() && !starts_with(at, &end) {
                at += 1;
            }
            at += end.len();
        } else if c == '\'' {
            // A character literal, or a lifetime, which is a mark followed by a word.
            let literal = chars.get(at + 1) == Some(&'\\') || chars.get(at + 2) == Some(&'\'');
            at += if !literal { 1 } else { 2 + chars[at + 2..].iter().take_while(|c| **c != '\'').count() + 1 };
        } else if c.is_alphabetic() || c == '_' {
            let word: String = chars[at..].iter().take_while(|c| c.is_alphanumeric() || **c == '_').collect();
            let begin = at;
            at += word.chars().count();
            tokens.push((begin, Token::Word(word)));
        } else if starts_with(at, "::") {
            tokens.push((at, Token::PathSeparator));
            at += 2;
        } else {
            if !c.is_whitespace() {
                tokens.push((at, Token::Mark(c)));
            }
            at += 1;
        }
    }
    tokens
}

pub fn word(token: Option<&Token>) -> Option<&str> {
    match token {
        Some(Token::Word(word)) => Some(word),
        _ => None,
    }
}

/// Words with which items start.
const ITEMS: [&str; 12] =
    ["fn", "mod", "impl", "struct", "enum", "const", "static", "use", "type", "trait", "unsafe", "async"];

/// Returns the end of the item or field that starts at `at`: after its closing brace or its semicolon, or after the
/// field's comma.
fn item_end(tokens: &[Token], mut at: usize) -> usize {
    // A field has no such word before its colon, its comma or the brace behind it.
    let head = tokens[at..].iter().take_while(|token| !matches!(token, Token::Mark(':' | ',' | '{' | '}' | ';')));
    let is_field = !head.into_iter().any(|token| word(Some(token)).is_some_and(|word| ITEMS.contains(&word)));
    let mut depth = 0;
    while at < tokens.len() {
        match tokens[at] {
            Token::Mark(',') if depth == 0 && is_field => return at + 1,
            Token::Mark('}') if depth == 0 => return at,
            Token::Mark('{' | '(' | '[') => depth += 1,
            Token::Mark('}') if depth == 1 => return at + 1,
            Token::Mark('}' | ')' | ']') => depth -= 1,
            Token::Mark(';') if depth == 0 => return at + 1,
            _ => {}
        }
        at += 1;
    }
    at
}

/// Returns the range of tokens of each item under `#[cfg(test)]`, including the attribute.
fn test_items(tokens: &[Token]) -> Vec<Range<usize>> {
    let attribute = ["#", "[", "cfg", "(", "test", ")", "]"];
    let is_attribute = |at: usize| {
        attribute.iter().enumerate().all(|(k, text)| match tokens.get(at + k) {
            Some(Token::Word(word)) => word == text,
            Some(Token::Mark(mark)) => *text == mark.to_string(),
            _ => false,
        })
    };
    let (mut items, mut at) = (Vec::new(), 0);
    while at < tokens.len() {
        if is_attribute(at) {
            let end = item_end(tokens, at + attribute.len());
            items.push(at..end);
            at = end;
        } else {
            at += 1;
        }
    }
    items
}

/// Returns the tokens without the items under `#[cfg(test)]`, and the names of the modules among these items.
pub fn tokens_without_tests(text: &str) -> (Vec<Token>, Vec<String>) {
    let mut tokens: Vec<Token> = placed_tokens(text).into_iter().map(|(_, token)| token).collect();
    let mut modules = Vec::new();
    for item in test_items(&tokens).into_iter().rev() {
        let name = tokens[item.clone()].iter().skip_while(|token| **token != Token::Word("mod".into())).nth(1);
        modules.extend(word(name).map(str::to_owned));
        tokens.drain(item);
    }
    (tokens, modules)
}

/// Returns the text without the items under `#[cfg(test)]`, wherever they stand. Every other line keeps its number.
pub fn text_without_tests(text: &str) -> String {
    let placed = placed_tokens(text);
    let tokens: Vec<Token> = placed.iter().map(|(_, token)| token.clone()).collect();
    let mut chars: Vec<char> = text.chars().collect();
    for item in test_items(&tokens) {
        let end = placed[item.end - 1].0;
        chars[placed[item.start].0..=end].iter_mut().filter(|c| **c != '\n').for_each(|c| *c = ' ');
    }
    chars.into_iter().collect()
}

/// A `loop` or `while`.
pub struct Loop {
    /// Number of its first line, from 1.
    pub line: usize,
    /// The tokens from the keyword up to the body.
    pub head: Vec<Token>,
    /// The tokens of the body, without its braces.
    pub body: Vec<Token>,
    /// The comment directly above the first line, or nothing.
    pub comment: String,
}

/// Returns the loops of a text, without those of items under `#[cfg(test)]`.
pub fn loops(text: &str) -> Vec<Loop> {
    let text = text_without_tests(text);
    let lines: Vec<&str> = text.lines().collect();
    let placed = placed_tokens(&text);
    let tokens: Vec<Token> = placed.iter().map(|(_, token)| token.clone()).collect();
    let is_loop = |at: &usize| matches!(word(tokens.get(*at)), Some("loop" | "while"));
    let read = |at: usize| {
        let begin = body_begin(&tokens, at);
        let end = item_end(&tokens, begin) - 1;
        let line = text.chars().take(placed[at].0).filter(|c| *c == '\n').count();
        let mut comment: Vec<&str> =
            lines[..line].iter().rev().map_while(|line| line.trim_start().strip_prefix("//")).collect();
        comment.reverse();
        Loop {
            line: line + 1,
            head: tokens[at..begin].to_vec(),
            body: tokens[begin + 1..end].to_vec(),
            comment: comment.join(" "),
        }
    };
    (0..tokens.len()).filter(is_loop).map(read).collect()
}

/// Returns the index of the brace that begins the body of the loop at `at`.
fn body_begin(tokens: &[Token], mut at: usize) -> usize {
    let mut depth = 0;
    while tokens[at] != Token::Mark('{') || depth > 0 {
        match tokens[at] {
            Token::Mark('(' | '[') => depth += 1,
            Token::Mark(')' | ']') => depth -= 1,
            _ => {}
        }
        at += 1;
    }
    at
}
