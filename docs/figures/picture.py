"""SVG pictures of what stands in the sphere frame S: lines and text; triangles are drawn into a PNG that the SVG carries."""

import base64
import struct
import zlib

import numpy as np


class View:
    """An orthographic view: directions `right` and `up` in S, where the sphere's centre is drawn, pixels a radius."""

    def __init__(self, right, up, centre, scale):
        self.axes = np.array([right, up, np.cross(right, up)], float)
        self.centre, self.scale = np.array(centre, float), scale

    @classmethod
    def from_direction(cls, azimuth, elevation, centre, scale):
        """Seen from a direction in degrees, the palm normal upward."""
        a, e = np.radians([azimuth, elevation])
        right = [-np.sin(a), np.cos(a), 0]
        up = [-np.sin(e) * np.cos(a), -np.sin(e) * np.sin(a), np.cos(e)]
        return cls(right, up, centre, scale)

    def __call__(self, p):
        """Picture coordinates x, y of points in S, and their depth, which grows toward the viewer."""
        v = np.asarray(p) @ self.axes.T
        x, y = self.centre[0] + self.scale * v[..., 0], self.centre[1] - self.scale * v[..., 1]
        return np.stack([x, y, v[..., 2]], -1)


def rasterise(corners, normals, view, width, height, samples=4):
    """Brightness and depth [height * samples, width * samples] of shaded triangles; depth is -inf where there are none."""
    p = view(corners)
    xy, depth = p[..., :2] * samples, p[..., 2]
    n = normals @ view.axes.T
    n = np.where(n[..., 2:] < 0, -n, n)
    light = np.array([-0.35, 0.55, 0.76])
    shade = 0.30 + 0.62 * np.clip(n @ light, 0, 1) + 0.10 * n[..., 2]
    rows, columns = height * samples, width * samples
    brightness, nearest = np.zeros((rows, columns)), np.full((rows, columns), -np.inf)
    for (a, b, c), z, s in zip(xy, depth, shade):
        x0, y0 = np.maximum(np.floor(np.minimum(np.minimum(a, b), c)).astype(int), 0)
        x1, y1 = np.minimum(np.ceil(np.maximum(np.maximum(a, b), c)).astype(int) + 1, (columns, rows))
        area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if x0 >= x1 or y0 >= y1 or abs(area) < 1e-9:
            continue
        x, y = np.arange(x0, x1) + 0.5, (np.arange(y0, y1) + 0.5)[:, None]
        u = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area
        v = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area
        z_here = z[0] + u * (z[1] - z[0]) + v * (z[2] - z[0])
        window = (slice(y0, y1), slice(x0, x1))
        seen = (u >= 0) & (v >= 0) & (u + v <= 1) & (z_here > nearest[window])
        nearest[window][seen] = z_here[seen]
        brightness[window][seen] = (s[0] + u * (s[1] - s[0]) + v * (s[2] - s[0]))[seen]
    return brightness, nearest


def png(grey, alpha):
    """A PNG of grey and alpha, both [rows, columns] in 0..1, in few steps so that it packs well."""
    def in_steps(channel, steps):
        return np.round(np.clip(channel, 0, 1) * steps) * (255 / steps)

    grey, alpha = in_steps(grey, 48), in_steps(alpha, 8)
    pixels = np.stack([np.where(alpha > 0, grey, 0), alpha], -1).astype(np.uint8)
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", pixels.shape[1], pixels.shape[0], 8, 4, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")


class Picture:
    """An SVG. Every position is in its pixels, y down."""

    def __init__(self, width, height, title):
        self.width, self.height, self.title, self.parts = width, height, title, []

    def add(self, element):
        self.parts.append(element)

    def circle(self, at, radius, **style):
        self.add(f'<circle cx="{at[0]:.1f}" cy="{at[1]:.1f}" r="{radius:g}"{attributes(style)}/>')

    def path(self, points, closed=False, **style):
        text = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in np.asarray(points)[:, :2]) + ("z" if closed else "")
        self.add(f'<path d="{text}"{attributes({"fill": "none", **style})}/>')

    def arrow(self, start, end, colour, width=2.0, head=9.0, **style):
        start, end = np.asarray(start)[:2], np.asarray(end)[:2]
        along = (end - start) / np.linalg.norm(end - start)
        across = np.array([-along[1], along[0]])
        self.path([start, end - 0.8 * head * along], stroke=colour, stroke_width=width, **style)
        barb, half = end - head * along, 0.38 * head * across
        self.path([end, barb + half, barb - half], closed=True, fill=colour)

    def text(self, at, words, size=15, anchor="middle", colour="#1d2733", bold=False, halo=True):
        style = {"font_size": size, "text_anchor": anchor, "fill": colour}
        if bold:
            style["font_weight"] = 600
        if halo:
            style.update(stroke="#fff", stroke_width=4, stroke_linejoin="round", paint_order="stroke")
        self.add(f'<text x="{at[0]:.1f}" y="{at[1]:.1f}"{attributes(style)}>{words}</text>')

    def image(self, x, y, width, height, data):
        self.add(f'<image x="{x:g}" y="{y:g}" width="{width:g}" height="{height:g}" '
                 f'href="data:image/png;base64,{base64.b64encode(data).decode()}"/>')

    def mesh(self, corners, normals, view, box, opacity=1.0, darkest=0.0, front_of=None, behind=None):
        """Shaded triangles within `box` (x, y, width, height). `front_of`, `behind`: only what lies on that side of the
        unit sphere. Returns a function that tells which points the triangles do not hide."""
        x, y, width, height = box
        moved = View(view.axes[0], view.axes[1], view.centre - (x, y), view.scale)
        samples, kept = 4, 2  # samples a pixel and side, pixels of the PNG a pixel of the picture
        brightness, depth = rasterise(corners, normals, moved, width, height, samples)
        inside = np.isfinite(depth)
        if front_of or behind:
            columns, rows = np.meshgrid(np.arange(width * samples) + 0.5, np.arange(height * samples) + 0.5)
            centre = moved([0, 0, 0])[:2]
            squared = ((columns / samples - centre[0]) ** 2 + (rows / samples - centre[1]) ** 2) / view.scale ** 2
            surface = np.where(squared < 1, np.sqrt(np.clip(1 - squared, 0, 1)), -np.inf)
            inside &= (depth > surface) if front_of else ~(depth > surface)

        def shrunk(channel):
            step = samples // kept
            return channel.reshape(height * kept, step, width * kept, step).mean((1, 3))

        alpha = shrunk(inside.astype(float))
        grey = shrunk(np.where(inside, darkest + (1 - darkest) * brightness, 0)) / np.maximum(alpha, 1e-9)
        self.image(x, y, width, height, png(grey, opacity * alpha))

        def seen(p, tolerance=0.02):
            column, row, height_of_p = np.moveaxis(moved(p), -1, 0)
            row = np.clip((row * samples).astype(int), 0, height * samples - 1)
            column = np.clip((column * samples).astype(int), 0, width * samples - 1)
            return height_of_p > depth[row, column] - tolerance
        return seen

    def write(self, path):
        body = "\n".join(self.parts)
        path.write_text(
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" role="img" '
            f'aria-labelledby="title" font-family="system-ui, Helvetica, Arial, sans-serif">\n'
            f'<title id="title">{self.title}</title>\n'
            f'<rect width="{self.width}" height="{self.height}" rx="10" fill="#fff"/>\n{body}\n</svg>\n')


def attributes(style):
    return "".join(f' {key.replace("_", "-")}="{value}"' for key, value in style.items())
