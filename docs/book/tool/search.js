// Finds sections whose heading or text contains every word that is typed. `words` (search-words.js): [address, heading, chapter, text] of each section.
const form = document.querySelector(".search"), field = form.querySelector("input"), list = form.querySelector("ol");
form.hidden = false;
form.addEventListener("submit", event => { event.preventDefault(); list.querySelector("a")?.click(); });
field.addEventListener("input", () => {
    const wanted = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    const found = !wanted.length ? [] : words.map(([address, heading, chapter, text]) => {
        const head = heading.toLowerCase(), body = text.toLowerCase();
        return { address, heading, chapter, rank: wanted.every(w => head.includes(w)) ? 2 : wanted.every(w => body.includes(w)) ? 1 : 0 };
    }).filter(entry => entry.rank).sort((a, b) => b.rank - a.rank).slice(0, 30);
    list.replaceChildren(...found.map(({ address, heading, chapter }) => {
        const item = document.createElement("li"), link = document.createElement("a");
        link.href = address; link.textContent = heading; item.append(link);
        if (chapter) { const place = document.createElement("small"); place.textContent = chapter; item.append(" ", place); }
        return item;
    }));
});
