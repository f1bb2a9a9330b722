//! Sections of a page that a command writes: what stands between `<!-- NAME -->` and `<!-- end -->`.

use anyhow::{Context, Result};
use std::ops::Range;

const END: &str = "<!-- end -->";

/// The page with a text in a section, in place of what stood there.
pub(crate) fn with_section(path: &str, page: &str, name: &str, text: &str) -> Result<String> {
    let mut page = page.to_owned();
    let range = range_of(path, &page, name)?;
    page.replace_range(range, text);
    Ok(page)
}

/// What stands in a section of a page.
pub(crate) fn section<'a>(path: &str, page: &'a str, name: &str) -> Result<&'a str> {
    Ok(&page[range_of(path, page, name)?])
}

fn range_of(path: &str, page: &str, name: &str) -> Result<Range<usize>> {
    let start = format!("<!-- {name} -->\n");
    let from = page
        .find(&start)
        .with_context(|| format!("{path} has no mark `{}`; add it", start.trim()))?
        + start.len();
    let until = from
        + page[from..].find(END).with_context(|| {
            format!(
                "{path} has no mark `{END}` after `{}`; add it",
                start.trim()
            )
        })?;
    Ok(from..until)
}
