# JSON, JSON Lines and HDF5 hold the same trajectory, whichever is read and whichever is written
/usr/bin/python3 - <<'END'
import h5py, json, random
random.seed(1)
names = [f"{finger}_joint_{i}" for finger in ("ring", "middle", "index", "thumb") for i in range(4)]
q = [[random.uniform(0.3, 0.6) for _ in names] for _ in range(1500)]
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
