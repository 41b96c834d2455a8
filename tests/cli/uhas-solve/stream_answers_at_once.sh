# the answer to a line comes before the next line is sent
/usr/bin/python3 - <<'END'
import subprocess
tool = subprocess.Popen(["uhas-solve", "-", "--profile", "profile/allegro_right.h5"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
for _ in range(3):
    tool.stdin.write("[" + ",".join(["0"] * 15) + "]\n")
    tool.stdin.flush()
    assert tool.stdout.readline().startswith('{"q":[')
tool.stdin.close()
assert tool.wait() == 0
END
