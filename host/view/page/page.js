"use strict";
// Follows the render: asks for its state, which is answered once there is news, and shows it.
const $ = id => document.getElementById(id);
let state = null, layers = [], layer = null, image = 0, isSet = false, pixel = null, isAsking = false;

function clock(seconds) {
  const s = Math.round(seconds), two = n => String(n).padStart(2, "0");
  return s >= 3600 ? `${Math.floor(s / 3600)}:${two(Math.floor(s / 60) % 60)}:${two(s % 60)}` : `${Math.floor(s / 60)}:${two(s % 60)}`;
}

function fill(table, rows) {
  table.replaceChildren(...rows.map(cells => {
    const row = document.createElement("tr");
    for (const cell of cells) {
      const td = document.createElement("td");
      td.append(cell);
      row.append(td);
    }
    return row;
  }));
}

function withBars(named) {
  const all = named.reduce((sum, [, seconds]) => sum + seconds, 0) || 1;
  return named.filter(([, seconds]) => seconds > 0).sort((a, b) => b[1] - a[1]).map(([name, seconds]) => {
    const bar = document.createElement("meter");
    bar.value = seconds / all;
    return [name, bar, `${seconds.toFixed(2)} s`];
  });
}

function showState(s) {
  document.title = `${s.hasEnded ? s.phase : Math.floor(100 * s.fraction) + " %"} · ${s.scene}`;
  $("scene").textContent = s.scene;
  $("phase").textContent = s.phase;
  $("phase").classList.toggle("ended", s.hasEnded);
  $("fraction").value = s.fraction;
  $("progress").textContent = [`${Math.floor(100 * s.fraction)} %`, `${+s.samples.toFixed(1)} of ${s.samplesInAll} samples`, `${clock(s.seconds)} elapsed`,
    ...s.secondsLeft !== null && !s.hasEnded ? [`${clock(s.secondsLeft)} left`] : []].join(" · ");
  const isGoingOn = s.phase === "rendering" || s.phase === "paused";
  $("pause").disabled = s.phase !== "rendering";
  $("goOn").disabled = s.phase !== "paused";
  $("save").disabled = $("stop").disabled = !isGoingOn;
  $("end").hidden = !s.hasEnded;
  $("saved").textContent = s.problem || (s.hasEnded ? `wrote ${s.files.join(", ")}` : s.saves ? `saved ${s.saves} ×` : "");
  const last = s.errors.at(-1), percent = e => +(100 * e).toPrecision(2);
  $("error").textContent = last ? `${percent(last[1])} % (${s.metric}), ${percent(last[2])} to ${percent(last[3])} %${s.doubt ? "; not reliable: " + s.doubt : ""}` : "";
  drawCurve($("curve"), s.errors, s.targetError);
  fill($("stages"), withBars(s.stages));
  fill($("steps"), withBars(s.steps));
}

function showLayers(channels) {
  layers = picture.layersOf(channels);
  const chosen = layer?.name;
  $("layer").replaceChildren(...layers.map(l => new Option(l.name)));
  layer = layers.find(l => l.name === chosen) ?? layers[0];
  $("layer").value = layer.name;
}

async function showPixel() {
  if (!pixel || isAsking || !state?.bounds) return;
  isAsking = true;
  const [x, y] = pixel;
  try {
    const answer = await fetch(`pixel?x=${x}&y=${y}`);
    if (answer.ok) {
      $("where").textContent = `${x}, ${y}`;
      fill($("pixel"), Object.entries(await answer.json()).map(([name, value]) => [name, value === null ? "none" : String(+value.toPrecision(6))]));
    }
  } catch { /* follow() says that the program has gone */ }
  isAsking = false;
  if (pixel[0] !== x || pixel[1] !== y) showPixel();
}

async function follow() {
  for (;;) {
    try {
      const answer = await fetch(state ? `state?after=${state.number}` : "state");
      if (!answer.ok) throw new Error(`the program answers ${answer.status}`);
      state = await answer.json();
      if (!isSet) { $("exposure").value = $("stops").value = state.exposure; $("tones").value = state.curve; isSet = true; }
      showState(state);
      if (state.image !== image && state.channels.length) {
        if (layers.flatMap(l => l.channels).every(c => state.channels.includes(c)) === false || !layers.length) showLayers(state.channels);
        await picture.load(state, layer);
        image = state.image;
        showPixel();
      }
      await new Promise(resolve => setTimeout(resolve, 200));
    } catch (error) {
      for (const button of ["pause", "goOn", "save", "stop"]) $(button).disabled = true;
      $("end").hidden = true;
      $("phase").classList.add("ended");
      $("notice").hidden = false;
      $("notice").textContent = state?.hasEnded ? `The render is over (${state.phase}) and the program has ended. This is its last image.`
                                                : `The program does not answer any more (${error.message}).`;
      if (!state?.hasEnded) $("phase").textContent = "gone";
      return;
    }
  }
}

for (const wish of ["pause", "goOn", "save", "stop", "end"])
  $(wish).addEventListener("click", () => fetch("wish", {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify({wish})}).catch(() => {}));
$("layer").addEventListener("change", () => { layer = layers.find(l => l.name === $("layer").value); picture.load(state, layer).catch(() => {}); });
$("exposure").addEventListener("input", e => { $("stops").value = e.target.value; picture.draw(); });
for (const control of ["tones", "logarithmic"]) $(control).addEventListener("change", () => picture.draw());
$("stage").addEventListener("pointermove", e => { const p = picture.pixelUnder(e); if (p) { pixel = p; showPixel(); } });
const legend = $("legend").getContext("2d"), bar = legend.createImageData(256, 10);
falseColors(Float32Array.from({length: 2560}, (_, i) => i % 256), [0, 255], false, bar.data);
legend.putImageData(bar, 0, 0);
follow();
