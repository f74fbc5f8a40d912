"use strict";
// The error against time, both logarithmic, with its interval and the error that is asked for.
function svgElement(name, attributes, text) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text) element.textContent = text;
  return element;
}

function drawCurve(svg, errors, target) {
  svg.replaceChildren();
  const points = errors.filter(e => e[0] > 0 && e[1] > 0);
  if (!points.length) return;
  const left = 34, right = 294, top = 6, bottom = 132;
  const span = values => {
    const low = Math.min(...values), high = Math.max(...values);
    return high > 1.2 * low ? [Math.log(low), Math.log(high)] : [Math.log(low / 1.1), Math.log(high * 1.1)];
  };
  const [t0, t1] = span(points.map(e => e[0]));
  const [e0, e1] = span(points.flatMap(e => [Math.max(e[2], e[1] / 10), Math.min(e[3], e[1] * 10)]).concat(target ? [target] : []));
  const x = t => left + (right - left) * (Math.log(t) - t0) / (t1 - t0), y = e => bottom - (bottom - top) * (Math.log(e) - e0) / (e1 - e0);
  const ticks = (low, high) => {
    const all = [];
    for (let d = Math.floor(low / Math.LN10); d <= high / Math.LN10; ++d)
      for (const m of [1, 2, 5]) if (Math.log(m) + d * Math.LN10 >= low && Math.log(m) + d * Math.LN10 <= high) all.push(m * 10 ** d);
    return all.length > 6 ? all.filter((_, i) => i % Math.ceil(all.length / 6) === 0) : all;
  };
  for (const t of ticks(t0, t1))
    svg.append(svgElement("line", {class: "grid", x1: x(t), x2: x(t), y1: top, y2: bottom}),
               svgElement("text", {x: x(t), y: bottom + 11, "text-anchor": "middle"}, +t.toPrecision(1) + " s"));
  for (const e of ticks(e0, e1))
    svg.append(svgElement("line", {class: "grid", x1: left, x2: right, y1: y(e), y2: y(e)}),
               svgElement("text", {x: left - 3, y: y(e) + 3, "text-anchor": "end"}, +(100 * e).toPrecision(1) + " %"));
  const at = (e, value) => `${x(e[0]).toFixed(1)},${y(Math.min(Math.max(value, Math.exp(e0)), Math.exp(e1))).toFixed(1)}`;
  svg.append(svgElement("polygon", {class: "band", points: [...points.map(e => at(e, e[3])), ...points.map(e => at(e, e[2])).reverse()].join(" ")}),
             svgElement("polyline", {class: "line", points: points.map(e => at(e, e[1])).join(" ")}));
  if (target) svg.append(svgElement("line", {class: "target", x1: left, x2: right, y1: y(target), y2: y(target)}));
}
