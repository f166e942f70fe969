//! Script elements of the page: `document.getElementById("id").textContent`.

use crate::evaluator::Evaluator;
use crate::value::{KnownText, ObjectId, ScriptPlace, ScriptValue};
use std::rc::Rc;

impl Evaluator<'_, '_> {
    /// A property of an element of the page.
    pub fn element_part(
        &mut self,
        id: ObjectId,
        key: &str,
        place: ScriptPlace,
    ) -> Option<ScriptValue> {
        let is_part = matches!(
            key,
            "textContent" | "innerText" | "innerHTML" | "text" | "type" | "firstChild"
        );
        let call = self.world.call_of(id).filter(|_| is_part)?;
        let (selector, _) = call.arguments.first()?;
        let name = match &*call.name {
            "getElementById" => selector.text()?,
            "querySelector" => selector.text()?.strip_prefix('#')?,
            _ => return None,
        };
        let text = self.page_element(name)?;
        match key {
            "type" => {
                let (_, page) = self.world.files.first()?;
                let (_, kind) = self.loader.element(page, name)?;
                Some(ScriptValue::Text(Rc::new(KnownText::written(&kind, place))))
            }
            "firstChild" => Some(self.text_node(id, text, place)),
            _ => Some(text),
        }
    }

    /// The only node in an element.
    fn text_node(&mut self, id: ObjectId, text: ScriptValue, place: ScriptPlace) -> ScriptValue {
        let known = (id, Rc::from("firstChild"));
        if let Some(node) = self.members.get(&known) {
            return ScriptValue::Object(*node);
        }
        let node = self.plain(place);
        for key in ["textContent", "data", "nodeValue"] {
            self.define(node, key, text.clone(), place);
        }
        self.define(node, "nodeType", ScriptValue::Number(3.0), place);
        self.define(node, "nextSibling", ScriptValue::Null, place);
        self.open(&ScriptValue::Object(node));
        self.members.insert(known, node);
        ScriptValue::Object(node)
    }

    /// The contents of an element of the page.
    pub fn page_element(&self, name: &str) -> Option<ScriptValue> {
        let (_, page) = self.world.files.first()?;
        let (range, _) = self.loader.element(page, name)?;
        let place = ScriptPlace {
            file: 0,
            start: range.start as u32,
            end: range.end as u32,
        };
        let text = KnownText::written(page.get(range)?, place);
        Some(ScriptValue::Text(Rc::new(text)))
    }
}
