"""The tools of `shaderlint mcp` with the protocol's official client library, and raw messages that
no client of it sends."""

import asyncio
import base64
import contextlib
import json
import os
import pathlib
import select
import struct
import subprocess
import tempfile

import pytest
from mcp import ClientSession, StdioServerParameters
from mcp.client.stdio import stdio_client

# Tests with `tools` are coroutines.
pytestmark = pytest.mark.anyio
# Limit of the text in an answer in bytes, including the note about omitted lines.
MAX_TEXT = 24_200

BROKEN = """void mainImage(out vec4 color, in vec2 at) {
    float wave = sin(at.x * 0.1) + 1;
    color = vec4(vec3(wave), 1.0);
    colour = 2.0;
}
"""
MENDED = BROKEN.replace("+ 1;", "+ 1.0;")
ROOT = """void mainImage(out vec4 color, in vec2 at) {
    vec2 uv = at / iResolution.xy;
    color = vec4(vec3(sqrt(uv.y - 0.5)), 1.0);
}
"""
PLAIN = """void mainImage(out vec4 color, in vec2 at) {
    color = vec4(at / iResolution.xy, 0.5, 1.0);
}
"""


class Tools:
    """A session with the server, in its own folder."""

    def __init__(self, session, folder):
        self.session = session
        self.folder = folder

    async def call(self, name, /, **arguments):
        """Calls a tool. Returns its texts, its images, and whether it failed."""
        result = await self.session.call_tool(name, arguments)
        texts = [block.text for block in result.content if block.type == "text"]
        pictures = [base64.b64decode(block.data) for block in result.content if block.type == "image"]
        assert texts and all(text.strip() for text in texts), f"{name}: empty answer"
        assert all(len(text.encode()) <= MAX_TEXT for text in texts), f"{name}: answer too long"
        return "\n".join(texts), pictures, bool(result.is_error)

    async def good(self, name, /, **arguments):
        """Calls a tool that must succeed. Returns its text."""
        text, _, failed = await self.call(name, **arguments)
        assert not failed, text
        return text

    async def bad(self, name, /, **arguments):
        """Calls a tool that must fail. Returns the error."""
        text, _, failed = await self.call(name, **arguments)
        assert failed, text
        return text

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return name

    def read(self, name):
        return (self.folder / name).read_text()


@pytest.fixture
def anyio_backend():
    return "asyncio"


@pytest.fixture
async def tools(shaderlint, tmp_path):
    server = StdioServerParameters(command=shaderlint, args=["mcp"], cwd=tmp_path)
    async with stdio_client(server) as (reader, writer), ClientSession(reader, writer) as client:
        await client.initialize()
        yield Tools(client, tmp_path)


async def test_tools_are_described(tools):
    listed = (await tools.session.list_tools()).tools
    assert [tool.name for tool in listed] == ["check", "fix", "format", "run", "explain", "port", "references"], listed
    for tool in listed:
        assert tool.description and tool.annotations.title
        for name, schema in tool.input_schema["properties"].items():
            assert schema["description"], f"{tool.name}: {name}"
        assert tool.input_schema["additionalProperties"] is False
        assert tool.annotations.read_only_hint == (tool.name in ("check", "run", "explain", "references"))
    heat = next(tool for tool in listed if tool.name == "run").input_schema["properties"]["heatmap"]
    kinds = [kind["const"] for kind in heat["anyOf"][0]["oneOf"]]
    assert kinds == ["steps", "cost", "divergence", "nan", "slope"], heat


async def test_check_reports_position_rule_and_edit(tools):
    tools.write("a.glsl", BROKEN)
    expected = "a.glsl:2:36: error int-float-mix: cannot add `int` to `float`; replace `1` with `1.0`"
    for text in (
        await tools.good("check", path="a.glsl"),
        await tools.good("check", path="."),
        await tools.good("check", code=BROKEN, name="a.glsl"),
    ):
        assert text.startswith(expected + "\n"), text
        assert "a.glsl:4:5: error undeclared-name" in text
        assert "Found 2 errors (1 shader in 1 file)" in text


async def test_check_accepts_options(tools):
    text = await tools.good("check", code=BROKEN, only=["undeclared-name"])
    assert "int-float-mix" not in text and "undeclared-name" in text, text
    code = "void main() { gl_FragColor = vec4(1.0); }"
    assert "error" not in await tools.good("check", code=code, name="a.frag", dialect="webgl1")
    assert "error" in await tools.good("check", code=code, name="a.frag", dialect="webgl2")
    assert "unknown rule" in await tools.bad("check", code=PLAIN, only=["no-such-rule"])


async def test_check_reports_success(tools):
    text = await tools.good("check", code=PLAIN)
    assert "1 shader in 1 file" in text and "error" not in text, text


async def test_check_reports_unreadable_input(tools):
    assert "no such file" in await tools.bad("check", path="missing.glsl")
    assert "not checked" in await tools.bad("check", path=tools.write("a.py", "print(1)\n"))
    assert "either `path` or `code`" in await tools.bad("check", path="a.py", code=PLAIN)
    assert "`path` or some `code`" in await tools.bad("check")
    assert "unknown field `file`" in await tools.bad("check", file="a.glsl")
    assert "`code`" in await tools.bad("check", path="-")


async def test_long_answers_are_truncated_and_keep_the_summary(tools):
    for number in range(160):
        tools.write(f"{number:03}.glsl", BROKEN)
    text = await tools.good("check", path=".")
    assert text.startswith("000.glsl:2:36: error"), text[:200]
    assert "lines omitted" in text
    assert "Found 320 errors (160 shaders in 160 files)" in text.splitlines()[-2], text[-500:]


async def test_a_path_may_look_like_an_option(tools):
    tools.write("--fix", BROKEN)
    text = await tools.call("check", path="--fix")
    assert tools.read("--fix") == BROKEN, text
    assert "--fix" in text[0], text


async def test_fix_shows_a_diff_and_writes_on_request(tools):
    name = tools.write("a.glsl", BROKEN)
    text = await tools.good("fix", path=name)
    assert "-    float wave = sin(at.x * 0.1) + 1;\n+    float wave = sin(at.x * 0.1) + 1.0;\n" in text
    assert tools.read(name) == BROKEN
    text = await tools.good("fix", path=name, write=True)
    assert tools.read(name) == MENDED
    assert "undeclared-name" in text and "int-float-mix" not in text, text


async def test_fix_of_a_text_returns_the_text(tools):
    text, _, failed = await tools.call("fix", code=BROKEN)
    assert not failed and text.startswith(MENDED), text
    assert "undeclared-name" in text, "the remaining diagnostics follow the text"
    assert "no fixes available" in await tools.good("fix", code=PLAIN)
    other = await tools.good("fix", code=BROKEN, only=["sqrt-negative"])
    assert "no fixes available" in other, other
    assert "only files" in await tools.bad("fix", code=BROKEN, write=True)
    long = BROKEN + "// something\n" * 3000
    assert "save it" in await tools.bad("fix", code=long)


async def test_unsafe_fixes_need_an_option(tools):
    name = tools.write("a.glsl", ROOT)
    await tools.good("fix", path=name, write=True)
    assert tools.read(name) == ROOT
    await tools.good("fix", path=name, write=True, unsafe_fixes=True)
    assert "sqrt(max(uv.y - 0.5, 0.0))" in tools.read(name)


async def test_run_returns_an_image_and_facts(tools):
    name = tools.write("a.glsl", ROOT)
    text, pictures, failed = await tools.call("run", path=name, size=[64, 48], report=True)
    assert not failed, text
    assert size_of(pictures[0]) == (64, 48)
    assert "50.0 % NaN" in text and "sqrt(uv.y - 0.5)" in text, text
    assert "written" not in text and tempfile.gettempdir() not in text, text


async def test_run_accepts_options(tools):
    for options, expected in (
        ({}, (480, 270)),
        ({"heatmap": "cost", "size": [32, 16], "time": 2.5}, (32, 16)),
        ({"show": {"name": "uv", "line": 2}, "size": [32, 16]}, (32, 16)),
        ({"mouse": {"x": 3, "y": 4, "down": True}, "frame": 3, "size": [8, 8]}, (8, 8)),
    ):
        text, pictures, failed = await tools.call("run", code=ROOT, **options)
        assert not failed and size_of(pictures[0]) == expected, (options, text)
    text, pictures, _ = await tools.call("run", code=PLAIN, sheet=4, size=[64, 36])
    assert size_of(pictures[0]) > (64, 36)
    assert text.count("operations per pixel") == 4 and "3 s, frame 180" in text, text
    code = "#version 300 es\nprecision highp float;\nuniform float level;\nout vec4 color;\n" \
        "void main() { color = vec4(level); }\n"
    text = await tools.good("run", code=code, uniforms={"level": 0.25})
    assert "mean 0.250" in text, text


async def test_references_are_grouped_by_declaration(tools):
    (tools.folder / "sdf.glsl").write_text("float disc(vec2 p) { return length(p) - 1.0; }\n")
    (tools.folder / "main.glsl").write_text(
        '#include "sdf.glsl"\nfloat disc(float x) { return x; }\n'
        "void mainImage(out vec4 c, in vec2 p) { c = vec4(disc(p) + disc(1.0)); }\n"
    )
    text = await tools.good("references", path="main.glsl", name="disc")
    groups = [[line.rsplit(": ", 1)[0] for line in group.splitlines()] for group in text.split("\n\n")]
    assert ["main.glsl:2:7: defined", "main.glsl:3:60: read"] in groups, text
    assert ["main.glsl:3:50: read", "sdf.glsl:1:7: defined"] in groups, text
    text = await tools.good("references", path="main.glsl", name="disc", line=2)
    assert "sdf.glsl" not in text, text
    assert "no symbol is named `disk`" in await tools.bad("references", path="main.glsl", name="disk")


async def test_format_writes_on_request(tools):
    code = "void mainImage(out vec4 c,in vec2 p){c=vec4(p.x);}\n"
    formatted = "void mainImage(out vec4 c, in vec2 p) { c = vec4(p.x); }\n"
    assert await tools.good("format", code=code) == formatted
    tools.write("a.glsl", code)
    assert "+void mainImage(out vec4 c, in vec2 p)" in await tools.good("format", path="a.glsl")
    assert (tools.folder / "a.glsl").read_text() == code
    await tools.good("format", path="a.glsl", write=True)
    assert (tools.folder / "a.glsl").read_text() == formatted
    assert "already formatted" in await tools.good("format", path="a.glsl")
    assert "unclosed bracket" in await tools.bad("format", code="void main( {")
    assert "`write` requires `path`" in await tools.bad("format", code=code, write=True)


async def test_answers_name_parameters_of_tools(tools):
    text = await tools.good("check", code="void mainImage(out vec4 c, in vec2 p) { float x = p; c = vec4(x); }")
    assert "the parameter `unsafe_fixes` of the tool `fix`" in text and "--" not in text, text
    assert "bonzomatic" in await tools.bad("check", code=PLAIN, host="bonzomatik")
    for text in ("(((((", "def f(x):\n    return x\n", '{"a": 1}'):
        await tools.bad("check", code=text)


async def test_run_reports_errors(tools):
    assert "int-float-mix" in await tools.bad("run", code=BROKEN)
    assert "at most 524288 pixels" in await tools.bad("run", code=PLAIN, size=[4096, 4096])
    assert "no variable `nothing`" in await tools.bad("run", code=PLAIN, show={"name": "nothing", "line": 1})


async def test_explain_returns_the_page_of_a_rule(tools):
    assert (await tools.good("explain", name="sqrt-negative")).startswith("# sqrt-negative\n")
    assert "did you mean `sqrt-negative`" in await tools.bad("explain", name="sqrt-negatve")
    assert "sqrt-negative" in await tools.good("explain")


async def test_port_returns_shaders(tools):
    text = await tools.good("port", code=PLAIN)
    assert text.startswith("image.frag:\n#version 300 es\n"), text[:200]
    assert "\npass.vert:\n" in text
    checked = text[len("image.frag:\n"):text.index("pass.vert:")]
    assert " error " not in await tools.good("check", code=checked, name="a.frag")


async def test_port_writes_pages_without_overwriting(tools):
    name = tools.write("a.glsl", PLAIN)
    assert "written: page.html" in await tools.good("port", path=name, output="page.html", verify=True)
    assert tools.read("page.html").startswith("<!doctype html>")
    assert "already exists" in await tools.bad("port", path=name, output="page.html")
    await tools.good("port", path=name, output="page.html", force=True)
    assert "pass `output` to write files" in await tools.bad("port", path=name, target="html")
    assert "expected one of `html`" in await tools.bad("port", path=name, target="cobol")


async def test_port_reports_errors(tools):
    text, _, _ = await tools.call("port", code=BROKEN)
    assert "int-float-mix" in text, text


async def test_calls_run_concurrently(tools):
    calls = [tools.good("check", code=PLAIN) for _ in range(20)]
    calls += [tools.good("run", code=PLAIN, size=[16, 16]) for _ in range(5)]
    assert all(await asyncio.gather(*calls))


@contextlib.contextmanager
def raw(shaderlint, folder):
    """A server in a folder, for raw messages."""
    pipe = subprocess.PIPE
    with subprocess.Popen([shaderlint, "mcp"], cwd=folder, stdin=pipe, stdout=pipe) as server:
        for message in BEGINNING:
            say(server, message)
        yield server


@contextlib.contextmanager
def running(server, folder):
    """Calls a tool whose process waits for a shader, as one that runs for long. At the end the process
    must exit."""
    os.mkfifo(folder / "a.glsl")
    say(server, called(2, "run", {"path": "a.glsl"}))
    # Returns when the process opens the file, too.
    writer = os.open(folder / "a.glsl", os.O_WRONLY)
    yield
    closed = select.poll()
    closed.register(writer, 0)
    assert closed.poll() == [(writer, select.POLLERR)]
    os.close(writer)


def test_a_cancelled_call_ends_its_process(shaderlint, tmp_path):
    with raw(shaderlint, tmp_path) as server:
        with running(server, tmp_path):
            say(server, {"jsonrpc": "2.0", "method": "notifications/cancelled", "params": {"requestId": 2}})
        say(server, called(3, "check", {"code": PLAIN}))
        while (answer := json.loads(server.stdout.readline()))["id"] != 3:
            assert answer["id"] == 1, "no answer to a cancelled call"
        assert not answer["result"]["isError"], answer


def test_the_server_exits_with_a_client_that_exits_immediately(shaderlint):
    done = subprocess.run([shaderlint, "mcp"], stdin=subprocess.DEVNULL, capture_output=True)
    assert (done.returncode, done.stdout) == (0, b""), done


def test_the_server_exits_with_a_client_that_exits_during_a_call(shaderlint, tmp_path):
    with raw(shaderlint, tmp_path) as server, running(server, tmp_path):
        server.stdin.close()
        server.wait()


def test_invalid_messages_are_answered_or_ignored(shaderlint, tmp_path):
    with raw(shaderlint, tmp_path) as server:
        for line in (b"this is no JSON\n", b"{}\n", b"[1, 2]\n", b"\xff\xfe\n", b"{" * 10_000 + b"\n"):
            server.stdin.write(line)
        say(server, called(2, "no-such-tool", {}))
        say(server, {"jsonrpc": "2.0", "id": 3, "method": "no/such/method"})
        say(server, {"jsonrpc": "2.0", "id": 4, "method": "tools/call", "params": {"name": "check", "arguments": 7}})
        say(server, called(5, "check", {"code": PLAIN}))
        answers = {}
        while 5 not in answers:
            answer = json.loads(server.stdout.readline())
            answers[answer.get("id")] = answer
        assert "no-such-tool" in answers[2]["error"]["message"], answers
        assert answers[3]["error"]["code"] == -32601, answers
        server.stdin.close()
        assert server.wait() == 0


BEGINNING = (
    {
        "jsonrpc": "2.0",
        "id": 1,
        "method": "initialize",
        "params": {
            "protocolVersion": "2025-06-18",
            "capabilities": {},
            "clientInfo": {"name": "test", "version": "1"},
        },
    },
    {"jsonrpc": "2.0", "method": "notifications/initialized"},
)


def called(number, name, arguments):
    params = {"name": name, "arguments": arguments}
    return {"jsonrpc": "2.0", "id": number, "method": "tools/call", "params": params}


def say(server, message):
    server.stdin.write(json.dumps(message).encode() + b"\n")
    server.stdin.flush()


def size_of(png):
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack(">II", png[16:24])
