//! Reads identifiers in paths, and the parameters of queries.

use crate::http::problem::Failure;

/// Returns an identifier in upper case, as the store keeps it. Identifiers are ULIDs in either case. Any other text
/// names no job, so the store is not asked.
pub fn checked(id: &str) -> Result<String, Failure> {
    let valid = id.len() == 26 && id.bytes().all(|byte| byte.is_ascii_alphanumeric());
    if valid { Ok(id.to_ascii_uppercase()) } else { Err(Failure::not_found("no such job")) }
}

/// Returns the parameters of a query. Unknown and repeated parameters are errors.
pub fn parameters<const N: usize>(query: Option<&str>, names: [&str; N]) -> Result<[Option<String>; N], Failure> {
    let mut values = [const { None }; N];
    for (name, value) in url::form_urlencoded::parse(query.unwrap_or_default().as_bytes()) {
        let index = names.iter().position(|known| *known == name).ok_or_else(|| Failure::unknown_parameter(&names))?;
        if values[index].is_some() {
            return Err(Failure::bad_query(format!("{} is given twice", names[index])));
        }
        values[index] = Some(value.into_owned());
    }
    Ok(values)
}

/// Returns the parameters of a query in order, unchecked.
pub fn pairs(query: Option<&str>) -> Vec<(String, String)> {
    url::form_urlencoded::parse(query.unwrap_or_default().as_bytes()).into_owned().collect()
}
