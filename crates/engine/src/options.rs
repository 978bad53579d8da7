//! Options: the members of a request that act only with some choices of its other members.
//!
//! Each kind has one table, `Optioned::OPTIONS`. The check of a request reads it, and so do the catalogue
//! (`GET /v1/objectives`) and the descriptions of the API document.

use plateau_strict_json::rejection::FieldError;
use schemars::JsonSchema;
use serde::Serialize;
#[cfg(not(feature = "explain"))]
use serde_json::Map;
use serde_json::Value;
use std::collections::BTreeMap;

/// A member of a request, and the choices with which it acts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RequestOption {
    pub name: &'static str,
    /// Alternatives, of which one must hold. A list without alternatives belongs to an option that always acts. All
    /// choices of an alternative must hold.
    pub needs: &'static [&'static [Choice]],
}

/// A member of the request and the values of it with which an option acts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Choice {
    pub member: &'static str,
    pub values: &'static [&'static str],
}

impl RequestOption {
    /// Returns the option that acts in every request.
    pub const fn always(name: &'static str) -> Self {
        Self { name, needs: &[] }
    }

    pub const fn with(name: &'static str, needs: &'static [&'static [Choice]]) -> Self {
        Self { name, needs }
    }

    /// Returns the choices with which the option acts, as a phrase, or `None` if it always acts. Choices that the
    /// request has made are left out.
    pub fn phrase(&self, is_made: impl Fn(&Choice) -> bool) -> Option<String> {
        let alternatives = self.needs.iter().map(|choices| {
            let open = choices.iter().filter(|choice| !is_made(choice));
            open.map(Choice::phrase).collect::<Vec<_>>().join(" and ")
        });
        (!self.needs.is_empty()).then(|| alternatives.collect::<Vec<_>>().join(", or "))
    }
}

/// Returns the choice of one of some values of a member.
pub(crate) const fn when(member: &'static str, values: &'static [&'static str]) -> Choice {
    Choice { member, values }
}

impl Choice {
    fn phrase(&self) -> String {
        let values: Vec<String> = self.values.iter().map(|value| format!("`{value}`")).collect();
        match values.as_slice() {
            [one] => format!("`{}: {}`", self.member, one.trim_matches('`')),
            [first @ .., last] => format!("`{}` {} or {last}", self.member, first.join(", ")),
            [] => String::new(),
        }
    }
}

/// The request type of a kind with its options.
pub(crate) trait Optioned {
    /// Every option of the kind, in the order of the catalogue.
    const OPTIONS: &'static [RequestOption];

    /// Lists that differ if they are empty from lists that are left out: the name of the list, and the name of the
    /// member in which the object with the list lies. Other empty lists count as left out.
    const EMPTY_LISTS: &'static [(&'static str, &'static str)] = &[];

    /// Returns the value of a member that the table names as a choice, or an empty text if the request has none because
    /// it is not valid.
    fn choice(&self, member: &str) -> &'static str;

    /// Returns an error for each given member that does not act for a reason other than a choice of the table.
    fn idle(&self, _given: &Given<'_>) -> Vec<FieldError> {
        Vec::new()
    }
}

/// The members that a request has.
#[derive(Debug)]
pub(crate) enum Given<'a> {
    /// Names of the members of the request itself. Members inside other members and null count as given.
    #[cfg(feature = "stored")]
    Names(&'a [String]),
    Body(&'a Value),
}

impl Given<'_> {
    /// Returns whether the request has the member with this JSON Pointer.
    pub fn has(&self, pointer: &str) -> bool {
        match self {
            #[cfg(feature = "stored")]
            Self::Names(names) => names.iter().any(|name| pointer.split('/').nth(1) == Some(name)),
            Self::Body(body) => body.pointer(pointer).is_some(),
        }
    }
}

/// Returns an error for each given member that does not act in this request.
pub(crate) fn idle_members<R: Optioned>(request: &R, given: &Given<'_>) -> Vec<FieldError> {
    let holds = |choice: &Choice| {
        let value = request.choice(choice.member);
        value.is_empty() || choice.values.contains(&value)
    };
    let acts = |option: &RequestOption| {
        option.needs.is_empty() || option.needs.iter().any(|choices| choices.iter().all(holds))
    };
    let idle = R::OPTIONS.iter().filter(|option| given.has(&format!("/{}", option.name)) && !acts(option));
    let errors = idle.filter_map(|option| {
        let detail = format!("has no effect in this request: it needs {}", option.phrase(holds)?);
        Some(FieldError::new(format!("/{}", option.name), detail))
    });
    errors.chain(request.idle(given)).collect()
}

/// An option of an objective in the catalogue.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(rename = "ObjectiveOption")]
pub struct ObjectiveOption {
    /// Name of the request's member.
    pub name: &'static str,
    /// Alternatives, of which one must hold for the option to act. Each names members of the request with the values
    /// that they may have; `true` and `false` are texts here, and `given` stands for the client's own initial mesh. The
    /// list is empty if the option always acts.
    pub needs: Vec<BTreeMap<&'static str, Vec<&'static str>>>,
}

/// Returns the options of a table that can act with an objective.
pub(crate) fn of_objective(options: &[RequestOption], objective: &str) -> Vec<ObjectiveOption> {
    const OBJECTIVE: &str = "objective";
    let can_hold = |choice: &Choice| choice.member != OBJECTIVE || choice.values.contains(&objective);
    let of = |option: &RequestOption| {
        let possible = option.needs.iter().filter(|choices| choices.iter().all(can_hold));
        let others = possible.map(|choices| {
            let others = choices.iter().filter(|choice| choice.member != OBJECTIVE);
            others.map(|choice| (choice.member, choice.values.to_vec())).collect::<BTreeMap<_, _>>()
        });
        let mut needs: Vec<_> = others.collect();
        if needs.is_empty() && !option.needs.is_empty() {
            return None;
        }
        if needs.iter().any(BTreeMap::is_empty) {
            needs.clear();
        }
        Some(ObjectiveOption { name: option.name, needs })
    };
    options.iter().filter_map(of).collect()
}

fn is_empty(value: &Value) -> bool {
    value.is_null() || value.as_array().is_some_and(Vec::is_empty)
}

/// Returns whether a member at any depth is null or an empty list.
pub(crate) fn has_empty(value: &Value) -> bool {
    match value {
        Value::Object(members) => members.values().any(|member| is_empty(member) || has_empty(member)),
        Value::Array(items) => items.iter().any(has_empty),
        _ => false,
    }
}

/// Removes the members that are null, and empty lists except those in `kept` (see [`Optioned::EMPTY_LISTS`]). Without
/// the schemas, members that the request must not have are removed too.
#[cfg(not(feature = "explain"))]
pub(crate) fn pruned(value: &Value, within: &str, kept: &[(&str, &str)]) -> Value {
    match value {
        Value::Object(members) => {
            let stays =
                |name: &str, member: &Value| !is_empty(member) || (member.is_array() && kept.contains(&(name, within)));
            let left = members.iter().filter(|(name, member)| stays(name, member));
            left.map(|(name, member)| (name.clone(), pruned(member, name, kept))).collect::<Map<_, _>>().into()
        }
        Value::Array(items) => items.iter().map(|item| pruned(item, within, kept)).collect(),
        other => other.clone(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    const OPTIONS: [RequestOption; 4] = [
        RequestOption::always("tolerance"),
        RequestOption::with("seed", &[&[when("objective", &["bending"])], &[when("mesh", &["random"])]]),
        RequestOption::with("caps", &[&[when("objective", &["area"]), when("closed", &["true"])]]),
        RequestOption::with("rim", &[&[when("domain", &["bezier", "nurbs", "film"])]]),
    ];

    #[test]
    fn an_objective_has_the_options_that_can_act_with_it() {
        let of = |objective| serde_json::to_value(of_objective(&OPTIONS, objective)).unwrap();
        let rim = json!({ "name": "rim", "needs": [{ "domain": ["bezier", "nurbs", "film"] }] });
        assert_eq!(
            of("area"),
            json!([
                { "name": "tolerance", "needs": [] },
                { "name": "seed", "needs": [{ "mesh": ["random"] }] },
                { "name": "caps", "needs": [{ "closed": ["true"] }] },
                rim,
            ])
        );
        assert_eq!(of("bending"), json!([{ "name": "tolerance", "needs": [] }, { "name": "seed", "needs": [] }, rim]));
    }

    #[test]
    fn the_choices_of_an_option_are_a_phrase() {
        let phrases = OPTIONS.map(|option| option.phrase(|_| false));
        assert_eq!(phrases[0], None);
        assert_eq!(phrases[1].as_deref(), Some("`objective: bending`, or `mesh: random`"));
        assert_eq!(phrases[2].as_deref(), Some("`objective: area` and `closed: true`"));
        assert_eq!(phrases[3].as_deref(), Some("`domain` `bezier`, `nurbs` or `film`"));
        let rest = OPTIONS[2].phrase(|choice| choice.member == "objective");
        assert_eq!(rest.as_deref(), Some("`closed: true`"));
    }
}
