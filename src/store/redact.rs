//! Addresses of databases without their passwords.

use std::borrow::Cow;

/// Returns `url` without its passwords, for logs and errors.
#[must_use]
pub fn redacted(url: &str) -> String {
    const PARAMETER: &str = "password=";
    let mut parts = url.split(PARAMETER);
    let before = without_user_password(parts.next().unwrap_or_default());
    let mut text = before.into_owned();
    for part in parts {
        let end = part.find('&').unwrap_or(part.len());
        text.push_str(PARAMETER);
        text.push_str("***");
        text.push_str(&part[end..]);
    }
    text
}

fn without_user_password(url: &str) -> Cow<'_, str> {
    let Some((scheme, rest)) = url.split_once("://") else { return Cow::Borrowed(url) };
    let authority_end = rest.find(['/', '?']).unwrap_or(rest.len());
    let Some(at) = rest[..authority_end].rfind('@') else { return Cow::Borrowed(url) };
    let Some(colon) = rest[..at].find(':') else { return Cow::Borrowed(url) };
    Cow::Owned(format!("{scheme}://{}:***{}", &rest[..colon], &rest[at..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passwords_are_removed_from_urls() {
        assert_eq!(redacted("postgres://me:secret@db:5432/plateau"), "postgres://me:***@db:5432/plateau");
        assert_eq!(redacted("postgres://me:a@b@db/plateau"), "postgres://me:***@db/plateau");
        assert_eq!(redacted("postgres://db/plateau?user=a:b@c"), "postgres://db/plateau?user=a:b@c");
        assert_eq!(redacted("postgres://a:b@db/x?password=c&host=d"), "postgres://a:***@db/x?password=***&host=d");
        assert_eq!(
            redacted("postgres://db/x?password=a&password=b&user=c"),
            "postgres://db/x?password=***&password=***&user=c"
        );
        assert_eq!(redacted("sqlite:///data/plateau.db"), "sqlite:///data/plateau.db");
    }
}
