# JSON, JSON Lines and HDF5 hold the same trajectory, whichever is read and whichever is written
for turn in -0.09 -0.06 -0.03 0 0.03 0.06 0.09; do
  echo "[$turn,$turn,$turn,$turn,0, 0.1,$turn,0,0.1,-0.1,$turn,0,0,0,0]"
done | uhas-solve - --profile profile/allegro_right.h5 > solved.jsonl
/usr/bin/python3 - <<'END'
import h5py, json
solved = [json.loads(line)["q"] for line in open("solved.jsonl")]
names = [f"{finger}_joint_{i}" for finger in ("index", "middle", "ring", "thumb") for i in range(4)]
q = [solved[n % 7] for n in range(1200)]  # more than the HDF5 code holds at a time
header = {"format": "uhas-trajectory", "version": 1, "joint_names": names}
json.dump(dict(header, q=q), open("a.json", "w"))
open("a.jsonl", "w").write("\n".join(map(json.dumps, [header, *q])))
with h5py.File("a.h5", "w") as file:  # names of variable length
    file["joint_names"], file["q"] = names, q
with h5py.File("b.hdf5", "w") as file:  # names of fixed length
    file["joint_names"], file["q"] = [name.encode() for name in names], q
END
for kind in json jsonl h5; do
  for source in a.json a.jsonl a.h5 b.hdf5; do
    uhas-retarget --from profile/allegro_right.h5 --to profile/allegro_right.h5 $source -o $source.$kind > /dev/null
  done
  cmp a.json.$kind a.jsonl.$kind && cmp a.json.$kind a.h5.$kind && cmp a.json.$kind b.hdf5.$kind && echo "$kind: the same from every kind"
done
/usr/bin/python3 - <<'END'
import h5py, json
document, lines, file = json.load(open("a.json.json")), [json.loads(line) for line in open("a.json.jsonl")], h5py.File("a.json.h5")
assert document["q"] == [line["q"] for line in lines[1:-1]] == file["q"][:].tolist()
assert document["residual_rms"] == [line["residual_rms"] for line in lines[1:-1]] == file["residual_rms"][:].tolist()
assert document["summary"] == lines[-1]["summary"] and document["joint_names"] == [n.decode() for n in file["joint_names"]]
assert file.attrs["format"] == b"uhas-trajectory" and file.attrs["version"] == 1 and file.attrs["hand"] == b"allegro_right"
END
#> json: the same from every kind
#> jsonl: the same from every kind
#> h5: the same from every kind
