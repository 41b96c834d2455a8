# the answer to a frame comes before the next frame is sent
/usr/bin/python3 - <<'END'
import subprocess
tool = subprocess.Popen(["uhas-retarget", "-", "--from", "profile/allegro_right.h5", "--to", "profile/allegro_right.h5"],
                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
for _ in range(3):
    tool.stdin.write("[" + ",".join(["0.4"] * 16) + "]\n")
    tool.stdin.flush()
    assert tool.stdout.readline().startswith('{"q":[')
tool.stdin.close()
assert tool.wait() == 0
END
