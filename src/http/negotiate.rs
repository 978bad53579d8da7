//! Reads headers about preferences, accepted media types, entity tags and ranges.

use axum::http::{HeaderMap, header};
use sha2::{Digest, Sha256};
use std::ops::Range;

/// Returns `N` of `Prefer: wait=N` (RFC 7240). Invalid preferences are ignored.
#[must_use]
pub fn prefer_wait_s(headers: &HeaderMap) -> Option<u64> {
    headers
        .get_all("prefer")
        .iter()
        .filter_map(|value| value.to_str().ok())
        .flat_map(|value| value.split(','))
        .filter_map(|preference| preference.split(';').next()?.split_once('='))
        .find(|(name, _)| name.trim().eq_ignore_ascii_case("wait"))
        .and_then(|(_, value)| value.trim().trim_matches('"').parse().ok())
}

/// Returns the index of the media type in `offered` with the highest quality in `Accept`. Among equal qualities the
/// first type is chosen, and without `Accept` the first type of all. Returns `None` if no offered type is accepted.
#[must_use]
pub fn accepted(headers: &HeaderMap, offered: &[&str]) -> Option<usize> {
    let values: Vec<&str> = headers.get_all(header::ACCEPT).iter().filter_map(|value| value.to_str().ok()).collect();
    if values.is_empty() {
        return Some(0);
    }
    let ranges: Vec<(&str, f64)> = values
        .iter()
        .flat_map(|value| value.split(','))
        .filter_map(|range| {
            let mut parts = range.split(';').map(str::trim);
            let media_type = parts.next().filter(|media_type| !media_type.is_empty())?;
            let quality = parts
                .filter_map(|parameter| parameter.split_once('='))
                .find(|(name, _)| name.trim().eq_ignore_ascii_case("q"))
                .and_then(|(_, value)| value.trim().parse::<f64>().ok());
            Some((media_type, quality.unwrap_or(1.0)))
        })
        .collect();
    let quality = |media_type: &str| {
        let kind = media_type.split('/').next().unwrap_or_default();
        // The most specific matching range decides (RFC 9110, 12.5.1).
        ranges
            .iter()
            .filter_map(|&(range, quality)| {
                if range.eq_ignore_ascii_case(media_type) {
                    Some((2, quality))
                } else if range.strip_suffix("/*").is_some_and(|prefix| prefix.eq_ignore_ascii_case(kind)) {
                    Some((1, quality))
                } else {
                    (range == "*/*").then_some((0, quality))
                }
            })
            .max_by_key(|&(specificity, _)| specificity)
            .map_or(0.0, |(_, quality)| quality)
    };
    let mut best: Option<(usize, f64)> = None;
    for (index, media_type) in offered.iter().enumerate() {
        let quality = quality(media_type);
        if quality > 0.0 && best.is_none_or(|(_, highest)| quality > highest) {
            best = Some((index, quality));
        }
    }
    best.map(|(index, _)| index)
}

/// Returns a strong entity tag, which is made from the hash of the representation's bytes.
#[must_use]
pub fn entity_tag(bytes: &[u8]) -> String {
    let digest = Sha256::digest(bytes);
    let hex: String = digest.iter().take(16).map(|byte| format!("{byte:02x}")).collect();
    format!("\"{hex}\"")
}

/// Returns true if `If-None-Match` names this tag (weak comparison, RFC 9110 13.1.2).
#[must_use]
pub fn none_match_hits(headers: &HeaderMap, tag: &str) -> bool {
    headers
        .get_all(header::IF_NONE_MATCH)
        .iter()
        .filter_map(|value| value.to_str().ok())
        .flat_map(|value| value.split(','))
        .map(str::trim)
        .any(|candidate| candidate == "*" || candidate.strip_prefix("W/").unwrap_or(candidate) == tag)
}

/// Requested part of a representation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Part {
    Whole,
    Range(Range<usize>),
    Unsatisfiable,
}

/// Reads `Range` and `If-Range`. Several ranges, other units and malformed values mean the whole representation (RFC
/// 9110, 14.2).
#[must_use]
pub fn part(headers: &HeaderMap, length: usize, tag: &str) -> Part {
    let text = |name| headers.get(name).and_then(|value: &axum::http::HeaderValue| value.to_str().ok());
    if text(header::IF_RANGE).is_some_and(|expected| expected != tag) {
        return Part::Whole;
    }
    let Some((first, last)) = text(header::RANGE)
        .and_then(|range| range.strip_prefix("bytes="))
        .and_then(|range| range.trim().split_once('-'))
        .filter(|(_, last)| !last.contains(','))
    else {
        return Part::Whole;
    };
    let digits = |text: &str| {
        text.bytes().all(|byte| byte.is_ascii_digit()).then(|| text.parse::<usize>().unwrap_or(usize::MAX))
    };
    match (first, last) {
        ("", "") => Part::Whole,
        ("", suffix) => match digits(suffix) {
            None => Part::Whole,
            Some(0) => Part::Unsatisfiable,
            Some(_) if length == 0 => Part::Unsatisfiable,
            Some(count) => Part::Range(length.saturating_sub(count)..length),
        },
        (first, last) => match (digits(first), if last.is_empty() { Some(usize::MAX) } else { digits(last) }) {
            (Some(first), Some(last)) if last < first => Part::Whole,
            (Some(first), Some(_)) if first >= length => Part::Unsatisfiable,
            (Some(first), Some(last)) => Part::Range(first..last.saturating_add(1).min(length)),
            _ => Part::Whole,
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use axum::http::{HeaderName, HeaderValue};

    fn headers(pairs: &[(&'static str, &'static str)]) -> HeaderMap {
        pairs.iter().map(|&(name, value)| (HeaderName::from_static(name), HeaderValue::from_static(value))).collect()
    }

    #[test]
    fn a_wait_is_found_among_other_preferences_and_invalid_ones_are_ignored() {
        assert_eq!(prefer_wait_s(&headers(&[("prefer", "respond-async, wait=10")])), Some(10));
        assert_eq!(prefer_wait_s(&headers(&[("prefer", "Wait = 3 ; x=y")])), Some(3));
        assert_eq!(prefer_wait_s(&headers(&[("prefer", "wait=-1")])), None);
        assert_eq!(prefer_wait_s(&headers(&[("prefer", "wait")])), None);
    }

    #[test]
    fn the_most_specific_range_decides() {
        let offered = ["model/gltf-binary", "model/gltf+json", "model/obj"];
        let pick = |accept| accepted(&headers(&[("accept", accept)]), &offered);
        assert_eq!(accepted(&HeaderMap::new(), &offered), Some(0));
        assert_eq!(pick("*/*"), Some(0));
        assert_eq!(pick("model/obj;q=0.5, model/gltf+json"), Some(1));
        assert_eq!(pick("model/*;q=0.9, model/gltf-binary;q=0"), Some(1));
        assert_eq!(pick("text/html"), None);
        assert_eq!(pick("*/*, model/gltf-binary;q=0.1"), Some(1));
    }

    #[test]
    fn ranges_are_cut_to_the_length() {
        let part = |range| part(&headers(&[("range", range)]), 10, "\"t\"");
        assert_eq!(part("bytes=0-3"), Part::Range(0..4));
        assert_eq!(part("bytes=4-"), Part::Range(4..10));
        assert_eq!(part("bytes=-3"), Part::Range(7..10));
        assert_eq!(part("bytes=-99999999999999999999999"), Part::Range(0..10));
        assert_eq!(part("bytes=10-"), Part::Unsatisfiable);
        for whole in ["bytes=3-1", "bytes=0-1,3-4", "lines=0-1", "bytes=a-b", "bytes=-", "bytes=+1-2"] {
            assert_eq!(part(whole), Part::Whole, "{whole}");
        }
    }

    #[test]
    fn an_if_range_of_another_version_returns_the_whole_file() {
        let asked = headers(&[("range", "bytes=0-3"), ("if-range", "\"old\"")]);
        assert_eq!(part(&asked, 10, "\"new\""), Part::Whole);
    }

    #[test]
    fn if_none_match_compares_weakly() {
        assert!(none_match_hits(&headers(&[("if-none-match", "\"a\", W/\"b\"")]), "\"b\""));
        assert!(none_match_hits(&headers(&[("if-none-match", "*")]), "\"b\""));
        assert!(!none_match_hits(&headers(&[("if-none-match", "\"a\"")]), "\"b\""));
    }
}
