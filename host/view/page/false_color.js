"use strict";
// False colours of one number per pixel: black, violet, orange, light yellow, with rising lightness.
const ramp = [[0, 0, 4], [40, 11, 84], [101, 21, 110], [159, 42, 99], [212, 72, 66], [245, 125, 21], [250, 193, 39], [252, 255, 164]];

function rampColor(t) {
  const x = Math.min(Math.max(t, 0), 1) * (ramp.length - 1), i = Math.min(Math.floor(x), ramp.length - 2);
  return ramp[i].map((c, k) => c + (ramp[i + 1][k] - c) * (x - i));
}

const rampTable = Uint8ClampedArray.from(Array.from({length: 256}, (_, i) => rampColor(i / 255)).flat());

// The range that all but the lowest and the highest 0.5 % of the finite values lie in; positive ones only, if it is for logarithms.
function rangeOf(values, logarithmic) {
  const step = Math.max(1, Math.floor(values.length / 50000)), some = [];
  for (let i = 0; i < values.length; i += step) if (Number.isFinite(values[i]) && values[i] < 1e10 && (!logarithmic || values[i] > 0)) some.push(values[i]);
  if (!some.length) return [0, 1];
  some.sort((a, b) => a - b);
  const low = some[Math.floor(0.005 * (some.length - 1))], high = some[Math.ceil(0.995 * (some.length - 1))];
  return [low, high > low ? high : low + (Math.abs(low) || 1)];
}

// Fills RGBA bytes. Values that are not finite are black.
function falseColors(values, [low, high], logarithmic, bytes) {
  const f = logarithmic ? Math.log : x => x, start = f(low), scale = 255 / (f(high) - start);
  for (let i = 0; i < values.length; ++i) {
    const v = (f(values[i]) - start) * scale, k = 3 * (v > 0 ? v < 255 ? Math.round(v) : 255 : 0);
    bytes[4 * i] = rampTable[k]; bytes[4 * i + 1] = rampTable[k + 1]; bytes[4 * i + 2] = rampTable[k + 2]; bytes[4 * i + 3] = 255;
  }
}
