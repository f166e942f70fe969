"""Random edits and requests, as nobody types and every editor may send.

After each burst the server's text is compared with the client's: opened under another name, the
client's text must have the same semantic tokens, outline and diagnostics. Every request has
exactly one response, no response reports an internal error, and memory does not grow without
bound. A seed determines the edits; the seed of a failing session is printed.
"""

import json
import os
import random
import subprocess

import pytest

from client import (
    CANCELLED, CONTENT_MODIFIED, REQUEST_FAILED, Client, Violation, everything, uri_of,
)
from harness import pulling
from text import Lines

BASE = """#include "lib.glsl"
// \u00e9\U0001d11e a scene
#define STEPS 32
#define SQUARE(x) ((x) * (x))
struct Hit { float t; vec3 normal; int id; };
const vec3 SKY = vec3(0.2, 0.4, 0.8);
uniform float gain; // 0..1

float sdBox(vec3 p, vec3 b) {
    vec3 q = abs(p) - b;
    return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0);
}

#if STEPS > 16
float map(vec3 p) { return min(sdBox(p, vec3(0.5)), noise(p.xz) * SQUARE(p.y)); }
#else
float map(vec3 p) { return sdBox(p, vec3(1.0)); }
#endif

Hit march(vec3 origin, vec3 ray) {
    Hit hit = Hit(0.0, vec3(0.0), -1);
    for (int i = 0; i < STEPS; i++) {
        float d = map(origin + ray * hit.t);
        if (d < 0.001) { hit.id = 1; break; }
        hit.t += d;
    }
    return hit;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (fragCoord - 0.5 * iResolution.xy) / iResolution.y; /* \U0001d11e */ float unused = 1.0;
    Hit hit = march(vec3(0.0, 0.0, -3.0 + sin(iTime)), normalize(vec3(uv, 1.0)));
    vec3 col = hit.id < 0 ? SKY : pow(hit.normal, vec3(0.5));
    fragColor = vec4(col, 1.0);
}
"""
LIBRARY = "float noise(vec2 p) { return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453); }\n"
PAGE = """<!doctype html>
<p>\u00e9\U0001d11e</p>
<script type="x-shader/x-fragment">#version 300 es
precision highp float;
in vec2 vUv;
out vec4 color;
uniform float gain;
void main() { color = vec4(vUv * gain, 0.0, 1.0); }
</script>
"""
# No name is a suffix of another: a truncated path never names its own file.
MORE = "float more(float x) { return x + 1.0; }\n"
STARTS = {"first.glsl": BASE, "second.glsl": BASE, "page.html": PAGE, "lib.glsl": LIBRARY, "more.glsl": MORE}
INCLUDED = ("lib.glsl", "more.glsl")
PIECES = [
    "{", "}", "(", ")", "[", "]", ";", ",", ".", "\n", "\r\n", "\r", " ", "\t", "#", "\\\n", "/*", "*/", "//",
    "#if 1\n", "#else\n", "#endif\n", "#define A(x) x##x\n", "#define STEPS 4\n", "#include \"lib.glsl\"\n",
    "#include \"more.glsl\"\n", "float", "vec3 v = vec3(1.0);\n", "hit.", "uv.xy", "SQUARE(", "SQUARE(uv.x)",
    "for (int i = 0; i < 9; i++) ", "if (true) ", "return 1.0;\n", "0", "1.0", "1e", "0x", "\"", "'", "`",
    "\u00e9", "\U0001d11e", "\u4e2d", "\u0000", "\ufeff", "const", "struct S { int a; };\n", "noise(", "mix(1.0, ",
    "void mainImage(out vec4 a, in vec2 b) { a = vec4(b, 0.0, 1.0); }\n", "gl_FragCoord", "texture(iChannel0, uv)",
    "// shaderlint: allow(", "// shaderlint: allow(unused-variable)\n", "int a[3] = int[3](1, 2, 3);\n",
]
PLACES = [
    "hover", "completion", "signatureHelp", "definition", "declaration", "typeDefinition",
    "documentHighlight", "prepareRename", "prepareCallHierarchy", "references", "rename",
    "onTypeFormatting", "selectionRange",
]
TEXTS = [
    "documentSymbol", "foldingRange", "documentColor", "codeLens", "formatting", "diagnostic",
    "semanticTokens/full", "semanticTokens/full/delta",
]
RANGES = ["codeAction", "inlayHint", "rangeFormatting", "semanticTokens/range", "colorPresentation"]
FORMAT = {"tabSize": 4, "insertSpaces": True}
# Error codes that a request may be answered with.
ALLOWED = (CANCELLED, CONTENT_MODIFIED, REQUEST_FAILED)


def name_of(uri):
    """The file name in a URI."""
    return uri.rsplit("/", 1)[-1]


class Typist:
    """Somebody who types into several texts at once."""

    def __init__(self, program, folder, seed):
        self.random = random.Random(seed)
        self.folder = folder
        for name, text in STARTS.items():
            with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        encoding = self.random.choice(["utf-8", "utf-16", "utf-32"])
        self.pulls = self.random.random() < 0.5
        capabilities = pulling() if self.pulls else everything()
        capabilities["general"]["positionEncodings"] = [encoding]
        self.client = Client([program, "lsp"], folder=self.folder, capabilities=capabilities,
                             settings={"shaderlint": {"run": True, "hints": {"types": True}}},
                             environment={"TMPDIR": self.folder})
        self.client.applies_edits = False
        self.token_ids = {}
        self.asked = []
        self.copies = 0
        for name, text in STARTS.items():
            self.client.open(self.uri(name), text, "html" if name.endswith("html") else "glsl")
        self.uris = list(self.client.documents)
        # A renamed copy of an included file would be a different text, so the others do not include
        # these.
        self.compared = [u for u in self.uris if not u.endswith(INCLUDED)]

    def uri(self, name):
        return uri_of(os.path.join(self.folder, name))

    # Edits.

    def edit(self):
        """One message with one or more changes."""
        uri = self.random.choice(self.uris)
        text = self.client.text(uri)
        changes = []
        for _ in range(self.random.choice([1, 1, 1, 1, 2, 3])):
            start, end, new = self.stretch(text)
            # `change` interprets positions in the text after the previous change.
            changes.append({"range": self.range_in(text, start, end), "text": new})
            text = text[:start] + new + text[end:]
        if self.random.random() < 0.01:
            changes = [{"text": STARTS[name_of(uri)]}]
        self.client.change(uri, changes)

    def stretch(self, text):
        """A range of a text, and its replacement."""
        choice = self.random.random()
        at = self.boundary(text, self.random.randint(0, len(text)))
        if choice < 0.45:
            return at, at, self.random.choice(PIECES)
        if choice < 0.75:
            return at, self.boundary(text, min(len(text), at + self.random.choice([1, 1, 1, 2, 5, 40]))), ""
        if choice < 0.9:
            lines = text.splitlines(keepends=True) or [""]
            first = self.random.randrange(len(lines))
            pasted = "".join(lines[first:first + self.random.randint(1, 3)])
            # Repeatedly doubling texts are covered by another test.
            return at, at, pasted if len(text) < 12_000 else ""
        end = self.boundary(text, min(len(text), at + self.random.randint(0, 12)))
        return at, end, self.random.choice(PIECES)

    @staticmethod
    def boundary(text, at):
        """A valid position: never between CR and LF."""
        return at + 1 if 0 < at < len(text) and text[at - 1:at + 1] == "\r\n" else at

    def range_in(self, text, start, end):
        return Lines(text, self.client.encoding).range(start, max(start, end))

    # Requests.

    def ask(self):
        """One request of a random kind; sometimes it is cancelled."""
        uri = self.random.choice(self.uris)
        text = self.client.text(uri)
        lines = self.client.lines(uri)
        at = self.boundary(text, self.random.randint(0, len(text)))
        end = self.boundary(text, self.random.randint(at, len(text)))
        position, range_ = lines.position(at), lines.range(at, max(at, end))
        params = {"textDocument": {"uri": uri}}
        kind = self.random.random()
        if kind < 0.5:
            method = self.random.choice(PLACES)
            params["position"] = position
            params.update({
                "references": {"context": {"includeDeclaration": True}},
                "rename": {"newName": self.random.choice(["renamed", "p", "float", "1x", "map"])},
                "onTypeFormatting": {"ch": self.random.choice("};"), "options": FORMAT},
                "selectionRange": {"positions": [position]},
            }.get(method, {}))
        elif kind < 0.75:
            method = self.random.choice(TEXTS)
            if method == "formatting":
                params["options"] = FORMAT
            if method.endswith("delta"):
                params["previousResultId"] = self.token_ids.get(uri, "none")
        elif kind < 0.95:
            method = self.random.choice(RANGES)
            params["range"] = range_
            params.update({
                "codeAction": {"context": {"diagnostics": []}},
                "rangeFormatting": {"options": FORMAT},
                "colorPresentation": {"color": {"red": 0.1, "green": 0.2, "blue": 0.3, "alpha": 1.0}},
            }.get(method, {}))
        else:
            return self.ask_workspace()
        number = self.client.send("textDocument/" + method, params)
        self.asked.append((number, uri))
        if self.random.random() < 0.15:
            self.client.notify("$/cancelRequest", {"id": number})
        return number

    def ask_workspace(self):
        method, params = self.random.choice([
            ("workspace/symbol", {"query": self.random.choice(["", "m", "noise"])}),
            ("workspace/diagnostic", {"previousResultIds": []}),
            ("workspace/executeCommand", {"command": "shaderlint.fixAll", "arguments": [self.uris[0]]}),
            ("shaderlint/page", {"textDocument": {"uri": self.uris[0]}}),
        ])
        number = self.client.send(method, params)
        self.asked.append((number, None))
        return number

    def burst(self):
        """A burst of edits and requests; all requests are answered."""
        for _ in range(self.random.randint(5, 60)):
            if self.random.random() < 0.6:
                self.edit()
            else:
                self.ask()
        for number, uri in self.asked:
            answer = self.client.wait(number)
            error = answer.get("error")
            if error and error["code"] not in ALLOWED:
                raise AssertionError("%s: %r" % (self.client.pending[number], error))
            result = answer.get("result")
            if uri and isinstance(result, dict) and "resultId" in result:
                self.token_ids[uri] = result["resultId"]
        self.asked.clear()
        if self.client.violations:
            raise Violation("; ".join(self.client.violations[:3]))

    # Comparing.

    def view(self, uri):
        """What the server reports for a text without sampling."""
        tokens = self.client.of(uri, "textDocument/semanticTokens/full")["data"]
        symbols = self.client.of(uri, "textDocument/documentSymbol")
        if self.pulls:
            told = self.client.of(uri, "textDocument/diagnostic")["items"]
        else:
            told = self.client.published(uri)
        return {"tokens": tokens, "symbols": symbols, "findings": static(told)}

    def compare(self):
        """The client's text, opened as another document, must have the same results as the
        server's."""
        uri = self.random.choice(self.compared)
        text = self.client.text(uri)
        self.copies += 1
        name = "copy%d.%s" % (self.copies, "html" if uri.endswith("html") else "glsl")
        copy = self.uri(name)
        language = "html" if uri.endswith("html") else "glsl"
        self.client.open(copy, text, language)
        try:
            own, other = self.view(uri), self.view(copy)
            if own["findings"] != other["findings"] and not self.pulls:
                # A text whose included file has changed is published again with its old version.
                own["findings"] = self.published_as(uri, other["findings"])
            for what in own:
                if own[what] != other[what]:
                    raise AssertionError("%s of %s differ, and %s:\n%r\n%r\nthe text is %r" % (
                        what, uri, self.touched(uri, other), own[what], other[what], text))
        finally:
            self.client.close(copy)

    def published_as(self, uri, expected):
        """The published diagnostics once they equal the expected ones, or the last ones
        otherwise."""
        try:
            return static(self.client.published_when(uri, lambda told: static(told) == expected))
        except TimeoutError:
            return static(self.client.published(uri))

    def touched(self, uri, other):
        """Whether the diagnostics are as expected after an edit and its reversal: then the error
        was in cached state of the server."""
        self.client.replace(uri, 0, 0, "\n")
        self.client.replace(uri, 0, 1, "")
        is_same = self.view(uri) == other
        return "no longer differ after a change: stale cached state" if is_same else "still differ after a change"


RUNTIME = set()


def static(findings):
    """The diagnostics that need no sampling, sorted."""
    ran = ("seen in a run", "sample run", "pixels of", "sampled ")
    return sorted(
        (d["range"]["start"]["line"], d["range"]["start"]["character"], d["range"]["end"]["line"],
         d["range"]["end"]["character"], d["code"], d["message"])
        for d in findings if not any(word in d["message"] for word in ran) and d["code"] not in RUNTIME)


@pytest.fixture(scope="module", autouse=True)
def runtime_rules(shaderlint):
    """Collects the rules that only sampling answers: their diagnostics arrive later."""
    out = subprocess.run([shaderlint, "rules", "--format", "json"], stdout=subprocess.PIPE, check=True)
    rules = json.loads(out.stdout)
    rules = rules["rules"] if isinstance(rules, dict) else rules
    RUNTIME.update(r["name"] for r in rules if r.get("group") == "runtime")


def resident(pid):
    """Resident memory of a process, in MB; None if the system does not report it."""
    try:
        with open("/proc/%d/status" % pid, encoding="ascii") as file:
            for line in file:
                if line.startswith("VmRSS:"):
                    return int(line.split()[1]) / 1024
    except OSError:
        pass
    return None


def test_answers_after_random_edits_equal_those_of_a_new_server(shaderlint, tmp_path, seed, bursts):
    typist = Typist(shaderlint, str(tmp_path), seed)
    early = None
    try:
        for burst in range(bursts):
            typist.burst()
            typist.compare()
            if burst % 40 == 39:
                # Reset the texts, because only broken brackets would accumulate and test little else.
                for uri in typist.uris:
                    typist.client.write_all(uri, STARTS[name_of(uri)])
            if burst == bursts // 4:
                early = resident(typist.client.process.pid)
        late = resident(typist.client.process.pid)
        assert not (early and late) or late <= early * 1.25 + 20, f"memory grows from {early} to {late} MB"
        typist.client.stop()
    finally:
        typist.client.kill()
