// The unit sphere: where a point of coordinates (theta, phi) stands, and its colour, the same on hand and sphere.
'use strict';

/// The point of canonical azimuth theta and polar angle phi at `radius` (sphere radii), in the sphere frame.
/// @param sign  -1 on a mirrored hand, whose canonical azimuth is the negative of the azimuth in the frame; else 1
function spherePoint(theta, phi, radius, sign) {
  const around = radius * Math.sin(phi);
  return [around * Math.cos(theta), sign * around * Math.sin(theta), -radius * Math.cos(phi)];
}

/// Colour of (theta, phi), sRGB in [0, 1], that of sphere_colour.cpp: the hue follows azimuth, the lightness falls from
/// the palm pole on. One chroma for all hues lets no azimuth stand out; it fades at the poles, where all azimuths meet.
function sphereColour(theta, phi) {
  const lightness = 0.86 - 0.14 * phi;
  const chroma = 0.13 * Math.sqrt(Math.abs(Math.sin(phi)));
  return srgbFromOklab(lightness, chroma * Math.cos(theta + 0.6), chroma * Math.sin(theta + 0.6));
}

/// B. Ottosson, "A perceptual color space for image processing", 2020.
function srgbFromOklab(lightness, a, b) {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.2914855480 * b) ** 3;
  return [4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s].map((linear) => {
    const value = clamp(linear, 0, 1);
    return value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055;
  });
}

/// Colours of n coordinates as a flat array [3 n].
function sphereColours(thetaPhi) {
  const colors = new Float32Array(thetaPhi.length / 2 * 3);
  for (let i = 0; i < thetaPhi.length / 2; ++i) colors.set(sphereColour(thetaPhi[2 * i], thetaPhi[2 * i + 1]), 3 * i);
  return colors;
}

/// The colours as a disc: the palm pole in the middle, the far pole at the rim, theta = 0 at the top, positive to the
/// left, as one sees the undeformed sphere of a right hand from the far side.
function colourKeyCanvas(size) {
  const canvas = element('canvas', {width: size, height: size, role: 'img', 'aria-label':
    'Colours of sphere coordinates: hue is azimuth theta, lightness falls from the palm pole in the middle'});
  const context = canvas.getContext('2d', {willReadFrequently: true});
  const image = context.createImageData(size, size);
  for (let row = 0; row < size; ++row) {
    for (let column = 0; column < size; ++column) {
      const up = 1 - (2 * row + 1) / size, left = 1 - (2 * column + 1) / size, distance = Math.hypot(up, left);
      if (distance > 1) continue;
      const color = sphereColour(Math.atan2(left, up), distance * Math.PI);
      image.data.set([...color.map((value) => 255 * value), 255], 4 * (row * size + column));
    }
  }
  context.putImageData(image, 0, 0);
  return canvas;
}
