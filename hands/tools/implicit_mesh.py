"""Shapes as signed distance functions, and closed triangle meshes of them.

A shape is a function of an array of points [n, 3] that is negative inside, positive outside and close to the distance
near the surface. Only additions, products, square roots, minima and maxima are used, which IEEE 754 rounds alike
everywhere: the same shape gives the same mesh, bit for bit, on every machine.
"""

import numpy as np


def round_box(low, high, radius):
    """The box from `low` to `high` with edges and corners rounded by `radius`."""
    low, high = np.asarray(low, float), np.asarray(high, float)
    centre, half = (low + high) / 2, (high - low) / 2 - radius

    def shape(p):
        q = np.abs(p - centre) - half
        outside = np.maximum(q, 0)
        return _length(outside) + np.minimum(np.max(q, axis=1), 0) - radius

    return shape


def cylinder(axis, centre, radius, half_length, edge):
    """A cylinder along coordinate `axis` (0, 1 or 2), its rims rounded by `edge`."""
    centre = np.asarray(centre, float)
    across = [i for i in range(3) if i != axis]

    def shape(p):
        q = p - centre
        radial = _length(q[:, across]) - (radius - edge)
        along = np.abs(q[:, axis]) - (half_length - edge)
        outside = _length(np.stack([np.maximum(radial, 0), np.maximum(along, 0)], axis=1))
        return outside + np.minimum(np.maximum(radial, along), 0) - edge

    return shape


def capsule(start, end, radius):
    """All points within `radius` of the segment from `start` to `end`."""
    start, end = np.asarray(start, float), np.asarray(end, float)
    direction = end - start
    squared = _dot(direction[None, :], direction)[0]

    def shape(p):
        t = np.minimum(np.maximum(_dot(p - start, direction) / squared, 0), 1)
        return _length(p - start - t[:, None] * direction) - radius

    return shape


def cone(start, end, start_radius, end_radius):
    """A tapered capsule: the hull of the balls about `start` and `end`."""
    start, end = np.asarray(start, float), np.asarray(end, float)
    length = _length((end - start)[None, :])[0]
    direction = (end - start) / length
    sine = (start_radius - end_radius) / length
    cosine = np.sqrt(1 - sine * sine)

    def shape(p):
        along = _dot(p - start, direction)
        radial = _length(p - start - along[:, None] * direction)
        foot = along * cosine - radial * sine
        side = radial * cosine + along * sine - start_radius
        return np.where(foot < 0, _length(p - start) - start_radius,
                        np.where(foot > length * cosine, _length(p - end) - end_radius, side))

    return shape


def half_space(point, normal):
    """All points behind the plane through `point` with the outward unit `normal`."""
    point, normal = np.asarray(point, float), np.asarray(normal, float)
    return lambda p: _dot(p - point, normal)


def union(a, b, blend):
    """Both shapes, the seam filled over about `blend`."""
    return lambda p: -_smooth_max(-a(p), -b(p), blend)


def intersection(a, b, blend):
    """What the shapes share, the edge rounded over about `blend`."""
    return lambda p: _smooth_max(a(p), b(p), blend)


def difference(a, b, blend):
    """The first shape without the second, the edge rounded over about `blend`."""
    return lambda p: _smooth_max(a(p), -b(p), blend)


def turned(shape):
    """The shape turned about the z axis so that its +x side faces -y."""
    return lambda p: shape(np.stack([-p[:, 1], p[:, 0], p[:, 2]], axis=1))


def mesh(shape, low, high, cell):
    """The surface of `shape` inside the box `low`..`high` as (vertices [n, 3], triangles [m, 3]), normals outward.

    Surface nets: one vertex in each cell of a grid that the surface crosses, one quadrilateral around each grid edge
    that it crosses. The vertices are evened out and drawn onto the surface; the result is closed by construction.
    """
    low, high = np.asarray(low, float), np.asarray(high, float)
    counts = np.ceil((high - low) / cell).astype(int) + 1
    start = (low + high) / 2 - (counts - 1) * cell / 2
    corners = np.stack(np.meshgrid(*[start[i] + cell * np.arange(counts[i]) for i in range(3)], indexing="ij"), axis=3)
    value = shape(corners.reshape(-1, 3)).reshape(counts)
    inside = value < 0
    if inside[[0, -1]].any() or inside[:, [0, -1]].any() or inside[:, :, [0, -1]].any():
        raise ValueError("the shape leaves the box it is meshed in")

    # one vertex a crossed cell: the mean of the points where the surface crosses the cell's edges
    cells = counts - 1
    total, crossings = np.zeros((*cells, 3)), np.zeros(cells)
    for axis in range(3):
        a = [slice(None)] * 3
        b = [slice(None)] * 3
        a[axis], b[axis] = slice(None, -1), slice(1, None)
        a, b = tuple(a), tuple(b)
        crossed = inside[a] != inside[b]
        t = np.where(crossed, value[a] / np.where(crossed, value[a] - value[b], 1), 0)
        point = corners[a] + t[..., None] * (corners[b] - corners[a])
        u, v = [i for i in range(3) if i != axis]
        for du in (0, 1):
            for dv in (0, 1):
                s = [slice(None)] * 3
                s[u], s[v] = slice(du, du + cells[u]), slice(dv, dv + cells[v])
                s = tuple(s)
                total += np.where(crossed[s][..., None], point[s], 0)
                crossings += crossed[s]
    used = crossings > 0
    index = np.full(cells, -1)
    index[used] = np.arange(np.count_nonzero(used))
    vertices = total[used] / crossings[used][:, None]

    # one quadrilateral a crossed edge, between the four cells around it
    quads = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        a = [slice(1, -1)] * 3
        b = [slice(1, -1)] * 3
        a[axis], b[axis] = slice(None, -1), slice(1, None)
        leaving = inside[tuple(a)] & ~inside[tuple(b)]
        entering = ~inside[tuple(a)] & inside[tuple(b)]
        around = []
        for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
            s = [slice(None)] * 3
            s[u], s[v] = slice(du, du + cells[u] - 1), slice(dv, dv + cells[v] - 1)
            around.append(index[tuple(s)])
        around = np.stack(around, axis=3)
        quads += [around[leaving], around[entering][:, ::-1]]
    quads = np.concatenate(quads)

    for _ in range(4):
        vertices = _on_surface(shape, _evened(vertices, quads), cell)
    return vertices, _split(vertices, quads)


def check_closed(vertices, triangles):
    """Raises ValueError unless the mesh is a closed two-manifold with outward normals and no sliver of zero area."""
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    directed = {(int(a), int(b)) for a, b in edges}
    if len(directed) != len(edges) or any((b, a) not in directed for a, b in directed):
        raise ValueError("the mesh is not a closed manifold")
    corner = vertices[triangles]
    normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    if np.min(_length(normal)) <= 0:
        raise ValueError("the mesh has a triangle without area")
    if np.sum(corner[:, 0] * normal) <= 0:
        raise ValueError("the mesh is inside out")


def _evened(vertices, quads):
    """Each vertex half-way towards the mean of its neighbours."""
    total, count = np.zeros_like(vertices), np.zeros(len(vertices))
    for i in range(4):
        for j in (1, 3):
            np.add.at(total, quads[:, i], vertices[quads[:, (i + j) % 4]])
            np.add.at(count, quads[:, i], 1)
    return (vertices + total / count[:, None]) / 2


def _on_surface(shape, vertices, cell):
    """The vertices drawn onto the surface by Newton steps along the gradient, none longer than half a cell."""
    step = cell * 2.0**-7
    for _ in range(3):
        gradient = np.stack([(shape(vertices + step * e) - shape(vertices - step * e)) / (2 * step) for e in np.eye(3)], 1)
        move = shape(vertices) / np.maximum(_dot(gradient, gradient), 0.25)
        move = np.minimum(np.maximum(move, -cell / 2), cell / 2)
        vertices = vertices - move[:, None] * gradient
    return vertices


def _split(vertices, quads):
    """Each quadrilateral as two triangles, along its shorter diagonal."""
    a, b, c, d = (vertices[quads[:, i]] for i in range(4))
    first = (_length(a - c) <= _length(b - d))[:, None]
    return np.concatenate([np.where(first, quads[:, [0, 1, 2]], quads[:, [0, 1, 3]]),
                           np.where(first, quads[:, [0, 2, 3]], quads[:, [1, 2, 3]])])


def _smooth_max(a, b, blend):
    overlap = np.maximum(blend - np.abs(a - b), 0)
    return np.maximum(a, b) + overlap * overlap / (4 * blend)


def _dot(a, b):
    product = a * b
    result = product[:, 0]
    for i in range(1, product.shape[1]):
        result = result + product[:, i]
    return result


def _length(a):
    return np.sqrt(_dot(a, a))
