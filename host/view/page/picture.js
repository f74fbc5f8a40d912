"use strict";
// The image on the page: its layers, tones, place and size, and the part that is cropped.
const picture = (() => {
  const $ = id => document.getElementById(id), canvas = $("picture"), stage = $("stage"), context = canvas.getContext("2d");
  let bounds = null, planes = null, layer = null, place = {x: 0, y: 0, scale: 1}, isFitted = true;

  const lights = ["image", "noisy", "emission", "direct", "indirect", "volume"];

  // Channels of one name belong together: albedo.R, albedo.G, albedo.B
  function layersOf(channels) {
    const groups = new Map();
    for (const c of channels) {
      const dot = c.startsWith("S0.") ? -1 : c.indexOf(".");
      const name = "RGB".includes(c) ? "image" : dot > 0 ? c.slice(0, dot) : c;
      groups.set(name, [...groups.get(name) ?? [], c]);
    }
    const layers = [];
    for (const [name, all] of groups) {
      if (all.length === 3) layers.push({name, channels: all, isLight: lights.includes(name), isColor: name === "albedo"});
      else for (const c of all) layers.push({name: c, channels: [c]});
    }
    if (channels.includes("variance")) layers.push({name: "relative error", channels: ["R", "G", "B", "variance"], isRelative: true});
    return layers;
  }

  const tones = {
    clamp: c => c,
    reinhard: c => { const l = Math.max(0, 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]); return c.map(v => v / (1 + l)); },
    filmic: c => c.map(x => x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14)),
  };
  const encoded = Uint8ClampedArray.from({length: 4096}, (_, i) => {
    const v = (i / 4095) ** 2;   // by roots, for the dark
    return Math.round(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055));
  });
  const stored = v => encoded[Math.round(4095 * Math.sqrt(v > 0 ? v < 1 ? v : 1 : 0))];

  function draw() {
    if (!planes) return;
    const pixels = context.createImageData(canvas.width, canvas.height), bytes = pixels.data, n = canvas.width * canvas.height;
    const isFalse = !(layer.channels.length === 3);
    $("light").hidden = !layer.isLight;
    $("falseColors").hidden = !isFalse;
    if (isFalse) {
      let values = planes[0];
      if (layer.isRelative)
        values = Float32Array.from(values, (r, i) => {
          const l = 0.2126 * r + 0.7152 * planes[1][i] + 0.0722 * planes[2][i];
          return Math.sqrt(planes[3][i] / (l * l + 0.01));
        });
      const isLogarithmic = $("logarithmic").checked, range = rangeOf(values, isLogarithmic);
      falseColors(values, range, isLogarithmic, bytes);
      $("low").textContent = +range[0].toPrecision(3);
      $("high").textContent = +range[1].toPrecision(3);
    } else {
      const gain = layer.isLight ? 2 ** +$("exposure").value : 1, bend = tones[layer.isLight ? $("tones").value : "clamp"], c = [0, 0, 0];
      for (let i = 0; i < n; ++i) {
        for (let k = 0; k < 3; ++k) {
          const v = planes[k][i];
          c[k] = layer.isLight ? Math.min(Math.max(v * gain, 0), 1e18) : layer.isColor ? v : 0.5 + 0.5 * v;   // directions lie in [-1, 1]
        }
        const toned = bend(c);
        for (let k = 0; k < 3; ++k) bytes[4 * i + k] = layer.isLight || layer.isColor ? stored(toned[k]) : 255 * toned[k];
        bytes[4 * i + 3] = 255;
      }
    }
    context.putImageData(pixels, 0, 0);
    canvas.dataset.layer = layer.name;
  }

  // A position is a point, not a direction: shown by the range of each coordinate.
  function spread(values) {
    const [low, high] = rangeOf(values, false);
    return values.map(v => 2 * (v - low) / (high - low) - 1);
  }

  async function load(state, wanted) {
    const answer = await fetch(`values?channels=${wanted.channels.map(encodeURIComponent).join(",")}`);
    if (!answer.ok) return;
    const values = new Float32Array(await answer.arrayBuffer());
    const [x0, x1, y0, y1] = state.bounds, n = (x1 - x0) * (y1 - y0);
    layer = wanted;
    planes = layer.channels.map((_, c) => values.subarray(c * n, (c + 1) * n));
    if (layer.name === "P") planes = planes.map(spread);
    const isNew = canvas.width !== x1 - x0 || canvas.height !== y1 - y0 || !bounds;
    bounds = state.bounds;
    if (isNew) { canvas.width = x1 - x0; canvas.height = y1 - y0; }
    draw();
    if (isNew || isFitted) fit();
  }

  function move() {
    canvas.style.transform = `translate(${place.x}px, ${place.y}px) scale(${place.scale})`;
  }
  function fit() {
    isFitted = true;
    place.scale = Math.min(stage.clientWidth / canvas.width, stage.clientHeight / canvas.height);
    place.x = (stage.clientWidth - canvas.width * place.scale) / 2;
    place.y = (stage.clientHeight - canvas.height * place.scale) / 2;
    move();
  }
  function zoom(factor, x, y) {
    isFitted = false;
    const scale = Math.min(Math.max(place.scale * factor, 0.02), 64);
    place.x = x - (x - place.x) * scale / place.scale;
    place.y = y - (y - place.y) * scale / place.scale;
    place.scale = scale;
    move();
  }
  // The pixel of the whole image below a point of the window.
  function pixelAt(event) {
    const r = stage.getBoundingClientRect();
    return [(event.clientX - r.left - place.x) / place.scale, (event.clientY - r.top - place.y) / place.scale];
  }
  function pixelUnder(event) {
    if (!bounds) return null;
    const [x, y] = pixelAt(event).map(Math.floor);
    return x >= 0 && y >= 0 && x < canvas.width && y < canvas.height ? [x + bounds[0], y + bounds[2]] : null;
  }

  let drag = null;
  function crop(event) {
    const clamped = (v, most) => Math.min(Math.max(v, 0), most), [ax, ay] = drag.from, [bx, by] = pixelAt(event);
    const x0 = Math.floor(clamped(Math.min(ax, bx), canvas.width - 1)), x1 = Math.max(Math.ceil(clamped(Math.max(ax, bx), canvas.width)), x0 + 1);
    const y0 = Math.floor(clamped(Math.min(ay, by), canvas.height - 1)), y1 = Math.max(Math.ceil(clamped(Math.max(ay, by), canvas.height)), y0 + 1);
    Object.assign($("crop").style, {left: `${place.x + x0 * place.scale}px`, top: `${place.y + y0 * place.scale}px`,
                                    width: `${(x1 - x0) * place.scale}px`, height: `${(y1 - y0) * place.scale}px`});
    $("crop").hidden = $("option").hidden = false;
    $("option").value = `--pixelbounds ${x0 + bounds[0]},${x1 + bounds[0]},${y0 + bounds[2]},${y1 + bounds[2]}`;
  }
  stage.addEventListener("pointerdown", e => {
    if (!bounds) return;
    stage.setPointerCapture(e.pointerId);
    drag = {from: pixelAt(e), x: e.clientX, y: e.clientY, crops: e.shiftKey || $("cropping").checked};
    $("crop").hidden = true;
  });
  stage.addEventListener("pointermove", e => {
    if (!drag) return;
    if (drag.crops) { crop(e); return; }
    isFitted = false;
    place.x += e.clientX - drag.x; place.y += e.clientY - drag.y;
    drag.x = e.clientX; drag.y = e.clientY;
    move();
  });
  stage.addEventListener("pointerup", () => { drag = null; });
  stage.addEventListener("wheel", e => {
    const r = stage.getBoundingClientRect();
    e.preventDefault();
    $("crop").hidden = true;
    zoom(2 ** (-e.deltaY / 300), e.clientX - r.left, e.clientY - r.top);
  }, {passive: false});
  $("cropping").addEventListener("change", e => stage.classList.toggle("cropping", e.target.checked));
  $("fit").addEventListener("click", fit);
  $("one").addEventListener("click", () => zoom(1 / place.scale, stage.clientWidth / 2, stage.clientHeight / 2));
  addEventListener("resize", () => { if (isFitted) fit(); });
  return {layersOf, load, draw, pixelUnder};
})();
