"""Starts the MCP server as its entry in the registry says, and asks it for its name.

    handshake.py SERVER_JSON     in a folder with the npm package
"""

import json
import subprocess
import sys

with open(sys.argv[1]) as file:
    entry = json.load(file)
package = next(p for p in entry["packages"] if p["registryType"] == "npm")
arguments = [argument["value"] for argument in package["packageArguments"]]
command = [package["runtimeHint"], package["identifier"], *arguments]
params = {"protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": {"name": "test", "version": "1"}}
request = {"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": params}
with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
    process.stdin.write(json.dumps(request) + "\n")
    process.stdin.flush()
    answer = json.loads(process.stdout.readline())
    process.stdin.close()
    assert answer["result"]["serverInfo"]["name"] == entry["title"], answer
    assert process.wait() == 0, process.returncode
