//! A checker for the keywords of JSON Schema that the schemas of the project contain; any other keyword is an
//! error of the test. `tests/teams/schemas.py` checks the same files with a complete validator.
use serde_json::{Map, Value};

/// A schema with its definitions.
pub struct Checker<'a>(pub &'a Value);

/// Keywords that accept every value.
const SILENT: [&str; 7] = ["$schema", "$defs", "title", "description", "default", "format", "then"];

impl Checker<'_> {
    /// Whether a value is valid.
    pub fn accepts(&self, value: &Value) -> bool {
        self.holds(self.0, value)
    }

    fn holds(&self, schema: &Value, value: &Value) -> bool {
        match schema {
            Value::Bool(accepts) => *accepts,
            Value::Object(keywords) => {
                keywords.iter().all(|(name, own)| self.keyword(keywords, name, own, value))
            }
            other => panic!("no schema: {other}"),
        }
    }

    fn keyword(&self, schema: &Map<String, Value>, name: &str, own: &Value, value: &Value) -> bool {
        let all = |own: &Value| {
            own.as_array().expect("an array").iter().filter(|one| self.holds(one, value)).count()
        };
        let number = |own: &Value| own.as_f64().expect("a number");
        match name {
            name if SILENT.contains(&name) => true,
            "$ref" => {
                let pointer =
                    own.as_str().and_then(|address| address.strip_prefix('#')).expect("a reference");
                self.holds(self.0.pointer(pointer).expect("a definition"), value)
            }
            "type" => match own {
                Value::Array(types) => types.iter().any(|own| is_of(own, value)),
                own => is_of(own, value),
            },
            "enum" => own.as_array().expect("an array").contains(value),
            "const" => own == value,
            "anyOf" => all(own) > 0,
            "oneOf" => all(own) == 1,
            "if" => {
                let branch = schema.get(if self.holds(own, value) { "then" } else { "else" });
                branch.is_none_or(|branch| self.holds(branch, value))
            }
            // Only in a schema with `if`.
            "else" => schema.contains_key("if"),
            "minimum" => value.as_f64().is_none_or(|value| value >= number(own)),
            "maximum" => value.as_f64().is_none_or(|value| value <= number(own)),
            "pattern" => {
                value.as_str().is_none_or(|value| matches_pattern(own.as_str().expect("a pattern"), value))
            }
            "minItems" => value.as_array().is_none_or(|list| list.len() as f64 >= number(own)),
            "maxItems" => value.as_array().is_none_or(|list| list.len() as f64 <= number(own)),
            "items" => value.as_array().is_none_or(|list| list.iter().all(|one| self.holds(own, one))),
            _ => value.as_object().is_none_or(|object| self.of_object(schema, name, own, object)),
        }
    }

    fn of_object(
        &self,
        schema: &Map<String, Value>,
        name: &str,
        own: &Value,
        object: &Map<String, Value>,
    ) -> bool {
        let properties = schema.get("properties").and_then(Value::as_object);
        match name {
            "required" => {
                let mut names = own.as_array().expect("an array").iter().filter_map(Value::as_str);
                names.all(|name| object.contains_key(name))
            }
            "properties" => {
                let mut properties = own.as_object().expect("an object").iter();
                properties.all(|(name, own)| object.get(name).is_none_or(|value| self.holds(own, value)))
            }
            "additionalProperties" => {
                let is_other = |name: &str| properties.is_none_or(|known| !known.contains_key(name));
                object.iter().filter(|(name, _)| is_other(name)).all(|(_, value)| self.holds(own, value))
            }
            "propertyNames" => object.keys().all(|name| self.holds(own, &Value::from(name.as_str()))),
            other => panic!("the checker does not know the keyword `{other}`"),
        }
    }
}

fn is_of(own: &Value, value: &Value) -> bool {
    match own.as_str().expect("the name of a type") {
        "null" => value.is_null(),
        "boolean" => value.is_boolean(),
        "string" => value.is_string(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        "number" => value.is_number(),
        "integer" => value.as_f64().is_some_and(|number| number.fract() == 0.0),
        other => panic!("the checker does not know the type `{other}`"),
    }
}

/// Whether a text matches one of the patterns of the schemas.
fn matches_pattern(pattern: &str, text: &str) -> bool {
    match pattern {
        "^[Tt][0-9]{1,4}$" => text.strip_prefix(['T', 't']).is_some_and(|digits| {
            (1..=4).contains(&digits.len()) && digits.bytes().all(|byte| byte.is_ascii_digit())
        }),
        "^https?://[^\\s]*$" => {
            let rest = text.strip_prefix("https://").or(text.strip_prefix("http://"));
            rest.is_some_and(|rest| !rest.contains(char::is_whitespace))
        }
        other => panic!("the checker does not know the pattern `{other}`"),
    }
}
