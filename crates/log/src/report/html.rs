//! Text that becomes a page.

use crate::markup::escaped;
use std::fmt::Write;

/// JSON that may stand inside a script element: nothing in it ends one.
pub(super) fn json(value: &serde_json::Value) -> String {
    value.to_string().replace('<', "\\u003c")
}

/// A template with each `{{name}}` replaced; what is put in is not looked at again.
///
/// # Panics
/// A name has no value: the template and its values are both ours.
pub(super) fn filled(template: &str, values: &[(&str, &str)]) -> String {
    let mut parts = template.split("{{");
    let mut page = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (name, rest) = part.split_once("}}").expect("every place has an end");
        let value = values.iter().find(|(key, _)| *key == name);
        page.push_str(value.expect("every place has a value").1);
        page.push_str(rest);
    }
    page
}

/// A table whose cells are escaped here; columns from `first_number` on are numbers.
pub(super) fn table(header: &[&str], first_number: usize, rows: &[Vec<String>]) -> String {
    let mut html = String::from("<div class=\"wide\"><table><thead><tr>");
    let class = |column: usize| {
        if column >= first_number {
            " class=\"number\""
        } else {
            ""
        }
    };
    for (column, name) in header.iter().enumerate() {
        put(
            &mut html,
            format_args!("<th{}>{}</th>", class(column), escaped(name)),
        );
    }
    html.push_str("</tr></thead><tbody>");
    for row in rows {
        html.push_str("<tr>");
        for (column, cell) in row.iter().enumerate() {
            put(
                &mut html,
                format_args!("<td{}>{}</td>", class(column), escaped(cell)),
            );
        }
        html.push_str("</tr>");
    }
    html.push_str("</tbody></table></div>");
    html
}

/// Rows of a quantity and its value.
pub(super) fn facts(rows: &[(&str, String)]) -> String {
    let mut html = String::from("<dl class=\"facts\">");
    for (name, value) in rows {
        let (name, value) = (escaped(name), escaped(value));
        put(&mut html, format_args!("<dt>{name}</dt><dd>{value}</dd>"));
    }
    html.push_str("</dl>");
    html
}

/// A section with a heading.
pub(super) fn section(id: &str, heading: &str, body: &str) -> String {
    format!(
        "<section id=\"{id}\"><h2>{}</h2>{body}</section>",
        escaped(heading)
    )
}

/// Writes into a text.
pub(super) fn put(text: &mut String, what: std::fmt::Arguments) {
    text.write_fmt(what)
        .expect("a text takes all that is written to it");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_that_is_put_in_is_a_tag_or_a_place() {
        let evil = "<script>alert('1')</script> & {{b}}";
        let page = filled("<p>{{a}}</p>{{b}}", &[("a", &escaped(evil)), ("b", "end")]);
        assert_eq!(
            page,
            "<p>&lt;script&gt;alert(&#39;1&#39;)&lt;/script&gt; &amp; {{b}}</p>end"
        );
        let json = json(&serde_json::json!({ "name": "</script><script>" }));
        assert!(!json.contains('<'), "{json}");
        assert!(table(&["<"], 1, &[vec!["<b>".into()]]).contains("&lt;b&gt;"));
        assert!(facts(&[("a", "<".into())]).contains("&lt;"));
    }
}
