uhas-solve actions.json --limit mesh=1G
#? 2
#2> uhas-solve: error: --limit: there is no limit mesh, the limits are urdf-bytes, links, mesh-bytes, triangles, config-bytes, json-bytes, actions, hdf5-bytes, read-seconds, read-memory; see uhas-solve --help
