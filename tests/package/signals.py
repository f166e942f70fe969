"""Whether a signal to the launcher ends the program, and the launcher the same way.

    signals.py COMMAND...     the command waits for input
"""

import signal
import subprocess
import sys

BODY = b'{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}}'

# Many times what a slow machine needs, in seconds: only a signal that is lost takes so long.
LIMIT = 120

with subprocess.Popen(sys.argv[1:], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
    process.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(BODY), BODY))
    process.stdin.flush()
    # The program has started when it answers.
    assert process.stdout.readline().startswith(b"Content-Length"), "no answer"
    process.send_signal(signal.SIGTERM)
    # The launcher ends after the program. The end of this block closes the input, which ends both.
    assert process.wait(LIMIT) == -signal.SIGTERM, process.returncode
