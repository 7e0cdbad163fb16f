// SPDX-License-Identifier: Apache-2.0
// The page of a study: parallel coordinates, front, pictures and table are views of one state.
'use strict';
(() => {
  const study = JSON.parse(document.getElementById('legwright-study').textContent);
  const { columns, rows, pictures } = study;
  const at = new Map(columns.map((column, i) => [column.name, i]));
  const designs = rows.map((_, i) => i).filter((i) => rows[i][at.get('status')] === 'done');
  const state = { axes: study.axes.slice(), ranges: new Map(), chosen: designs[0] ?? -1 };
  const byId = (id) => document.getElementById(id);
  const pass = at.get('pass');

  const make = (name, attributes = {}, text = '', svg = false) => {
    const node = svg
      ? document.createElementNS('http://www.w3.org/2000/svg', name)
      : document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
    if (text !== '') node.textContent = text;
    return node;
  };
  const draw = (name, attributes, text = '') => make(name, attributes, text, true);

  const show = (value) => {
    if (value === null || value === undefined) return '–';
    if (value === true) return 'yes';
    if (value === false) return 'no';
    if (typeof value !== 'number') return String(value);
    if (Number.isInteger(value)) return String(value);
    return String(Number(value.toPrecision(4)));
  };
  const label = (i) => columns[i].name + (columns[i].unit ? ` [${columns[i].unit}]` : '');
  const numeric = (i) => columns[i].kind === 'int64' || columns[i].kind === 'float64';
  const value = (row, i) => rows[row][i];

  // A scale maps values of a column to 0 … 1; what is not a number has its rung, in order.
  const scales = new Map();
  const scale = (i) => {
    if (scales.has(i)) return scales.get(i);
    const there = designs.map((row) => value(row, i)).filter((each) => typeof each === 'number'
      || (!numeric(i) && each !== null));
    let made;
    if (numeric(i)) {
      const low = Math.min(...there), high = Math.max(...there);
      const place = (v) => (typeof v !== 'number' ? null : high > low ? (v - low) / (high - low) : 0.5);
      made = { place, low, high, step: 0.02, word: (t) => show(low + t * (high - low)) };
    } else {
      const words = [...new Set(there)].sort();
      const place = (v) => {
        const found = words.indexOf(v);
        return found < 0 ? null : words.length > 1 ? found / (words.length - 1) : 0.5;
      };
      const step = words.length > 1 ? 1 / (words.length - 1) : 0.5;
      made = { place, words, step, word: (t) => show(words[Math.round(t * (words.length - 1))]) };
    }
    scales.set(i, made);
    return made;
  };

  const inside = (row) => [...state.ranges].every(([i, [low, high]]) => {
    const t = scale(i).place(value(row, i));
    return t === null ? low <= 0 : t >= low - 1e-9 && t <= high + 1e-9;
  });

  const colour = (row) => {
    const chosen = byId('colour').value;
    if (chosen === 'verdict') {
      const passed = pass === undefined ? null : value(row, pass);
      return passed === null ? 'var(--pale)' : passed ? 'var(--good)' : 'var(--bad)';
    }
    const i = at.get(chosen), t = scale(i).place(value(row, i));
    if (t === null) return 'var(--pale)';
    return `color-mix(in oklab, var(--c2) ${Math.round(100 * t)}%, var(--c1))`;
  };

  // ---- parallel coordinates ----

  const WIDTH = 1120, TOP = 46, SIDE = 60;
  let HEIGHT = 280, BOTTOM = 16;
  const across = (k) => state.axes.length > 1
    ? SIDE + (k * (WIDTH - 2 * SIDE)) / (state.axes.length - 1) : WIDTH / 2;
  const down = (t) => (t === null ? HEIGHT - 10 : TOP + (1 - t) * (HEIGHT - TOP - BOTTOM));

  const polyline = (row) => state.axes
    .map((i, k) => `${across(k).toFixed(1)},${down(scale(i).place(value(row, i))).toFixed(1)}`)
    .join(' ');

  const moveRange = (i, which, t) => {
    const range = state.ranges.get(i) ?? [0, 1];
    const clamped = Math.min(1, Math.max(0, t));
    range[which] = which === 0 ? Math.min(clamped, range[1]) : Math.max(clamped, range[0]);
    if (range[0] <= 0 && range[1] >= 1) state.ranges.delete(i);
    else state.ranges.set(i, range);
  };

  const addHandle = (group, i, which) => {
    const t = (state.ranges.get(i) ?? [0, 1])[which];
    const y = down(t), tip = which === 0 ? 9 : -9;
    const handle = draw('path', {
      d: `M-7,${y + tip} L7,${y + tip} L0,${y} Z`, class: 'handle', tabindex: '0', role: 'slider',
      'aria-label': `${label(i)}: ${which === 0 ? 'least' : 'most'} that is shown`,
      'aria-valuenow': String(Math.round(100 * t)), 'aria-valuemin': '0', 'aria-valuemax': '100',
      'aria-valuetext': scale(i).word(t), id: `handle-${i}-${which}`,
    });
    handle.append(draw('title', {}, `${which === 0 ? 'from' : 'to'} ${scale(i).word(t)}`));
    const to = (next) => { moveRange(i, which, next); refresh(); };
    handle.addEventListener('keydown', (event) => {
      const step = scale(i).step;
      const moves = { ArrowUp: t + step, ArrowRight: t + step, ArrowDown: t - step,
        ArrowLeft: t - step, Home: 0, End: 1, Escape: which };
      if (!(event.key in moves)) return;
      event.preventDefault();
      to(moves[event.key]);
      byId(`handle-${i}-${which}`).focus();
    });
    handle.addEventListener('pointerdown', (event) => {
      event.preventDefault();
      const box = byId('parallel').getBoundingClientRect();
      const drag = (move) => {
        const y = ((move.clientY - box.top) * HEIGHT) / box.height;
        to((HEIGHT - BOTTOM - y) / (HEIGHT - TOP - BOTTOM));
      };
      const end = () => {
        window.removeEventListener('pointermove', drag);
        byId(`handle-${i}-${which}`)?.focus();
      };
      window.addEventListener('pointermove', drag);
      window.addEventListener('pointerup', end, { once: true });
    });
    group.append(handle);
  };

  const addAxis = (svg, i, k) => {
    const group = draw('g', { transform: `translate(${across(k).toFixed(1)},0)` });
    group.append(draw('line', { x1: 0, x2: 0, y1: down(1), y2: down(0), class: 'axis' }));
    const end = k === 0 ? 'start' : k === state.axes.length - 1 ? 'end' : 'middle';
    const x = k === 0 ? -SIDE + 4 : k === state.axes.length - 1 ? SIDE - 4 : 0;
    const title = draw('text', { x, y: 14 + (k % 2) * 14, 'text-anchor': end, class: 'name' }, label(i));
    title.append(draw('title', {}, columns[i].about));
    group.append(title);
    const { words } = scale(i);
    if (words && words.length <= 12) {
      for (const word of words)
        group.append(draw('text', { x: 10, y: down(scale(i).place(word)) - 4 }, show(word)));
    } else {
      group.append(draw('text', { x: 10, y: down(1) - 4 }, scale(i).word(1)));
      group.append(draw('text', { x: 10, y: down(0) + 13 }, scale(i).word(0)));
    }
    addHandle(group, i, 0);
    addHandle(group, i, 1);
    svg.append(group);
  };

  const drawParallel = (shown) => {
    const svg = byId('parallel');
    svg.replaceChildren();
    const without = state.axes.some((i) => designs.some((row) => scale(i).place(value(row, i)) === null));
    BOTTOM = without ? 40 : 16;
    HEIGHT = 264 + BOTTOM;
    svg.setAttribute('viewBox', `0 0 ${WIDTH} ${HEIGHT}`);
    if (without) svg.append(draw('text', { x: 4, y: HEIGHT - 14 }, 'none'));
    svg.style.setProperty('--faint', String(Math.max(0.15, Math.min(0.7, 40 / shown.length))));
    const kept = new Set(shown);
    const rank = (row) => (!kept.has(row) ? 0 : row === state.chosen ? 2 : 1);
    for (const row of designs.slice().sort((a, b) => rank(a) - rank(b))) {
      const line = draw('polyline', { points: polyline(row), class: 'design-line' });
      line.classList.toggle('out', !kept.has(row));
      if (row === state.chosen && kept.has(row)) line.classList.add('chosen-line');
      line.style.stroke = colour(row);
      line.append(draw('title', {}, value(row, at.get('name'))));
      if (kept.has(row)) line.addEventListener('click', () => choose(row));
      svg.append(line);
    }
    state.axes.forEach((i, k) => addAxis(svg, i, k));
  };

  // ---- the front of two columns ----

  const onFront = (shown, x, y) => {
    const sign = (id) => (byId(id).value === 'least' ? 1 : -1);
    const sx = sign('x-better'), sy = sign('y-better');
    const sorted = shown
      .filter((row) => typeof value(row, x) === 'number' && typeof value(row, y) === 'number')
      .filter((row) => !byId('passing').checked || value(row, pass) === true)
      .sort((a, b) => sx * (value(a, x) - value(b, x)) || sy * (value(a, y) - value(b, y)));
    const front = [];
    let best = Infinity;
    for (const row of sorted) {
      if (sy * value(row, y) >= best) continue;
      best = sy * value(row, y);
      front.push(row);
    }
    return front;
  };

  const ticks = (low, high) => {
    if (!(high > low)) return [low];
    const rough = (high - low) / 5, ten = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 5, 10].map((each) => each * ten).find((each) => each >= rough);
    const out = [];
    for (let v = Math.ceil(low / step) * step; v <= high + 1e-9 * step; v += step) out.push(v);
    return out;
  };

  const drawFront = (shown) => {
    const svg = byId('front'), x = at.get(byId('x').value), y = at.get(byId('y').value);
    svg.replaceChildren();
    const there = shown.filter((row) => typeof value(row, x) === 'number' && typeof value(row, y) === 'number');
    const W = 620, H = 360, L = 64, R = 16, T = 12, B = 44;
    if (!there.length) {
      svg.append(draw('text', { x: L, y: H / 2 }, 'no design has both numbers'));
      return;
    }
    const span = (i) => {
      const all = there.map((row) => value(row, i));
      const low = Math.min(...all), high = Math.max(...all), pad = (high - low) * 0.06 || Math.abs(high) * 0.1 || 1;
      return [low - pad, high + pad];
    };
    const [x0, x1] = span(x), [y0, y1] = span(y);
    const px = (v) => L + ((v - x0) / (x1 - x0)) * (W - L - R);
    const py = (v) => H - B - ((v - y0) / (y1 - y0)) * (H - T - B);
    for (const v of ticks(x0, x1)) {
      svg.append(draw('line', { x1: px(v), x2: px(v), y1: T, y2: H - B, class: 'grid' }));
      svg.append(draw('text', { x: px(v), y: H - B + 16, 'text-anchor': 'middle' }, show(v)));
    }
    for (const v of ticks(y0, y1)) {
      svg.append(draw('line', { x1: L, x2: W - R, y1: py(v), y2: py(v), class: 'grid' }));
      svg.append(draw('text', { x: L - 8, y: py(v) + 4, 'text-anchor': 'end' }, show(v)));
    }
    svg.append(draw('text', { x: (L + W - R) / 2, y: H - 8, 'text-anchor': 'middle', class: 'name' }, label(x)));
    svg.append(draw('text', { x: 14, y: (T + H - B) / 2, 'text-anchor': 'middle', class: 'name',
      transform: `rotate(-90 14 ${(T + H - B) / 2})` }, label(y)));
    const front = onFront(shown, x, y);
    state.front = front;
    const corner = front.map((row, k) => {
      const [a, b] = [px(value(row, x)), py(value(row, y))];
      return k ? `L${a},${py(value(front[k - 1], y))} L${a},${b}` : `M${a},${b}`;
    });
    if (front.length > 1) svg.append(draw('path', { d: corner.join(' '), class: 'front-line' }));
    const rank = (row) => (row === state.chosen ? 2 : front.includes(row) ? 1 : 0);
    for (const row of there.slice().sort((a, b) => rank(a) - rank(b))) {
      const dot = draw('circle', { cx: px(value(row, x)), cy: py(value(row, y)), class: 'dot',
        r: row === state.chosen ? 8 : front.includes(row) ? 6 : 4 });
      dot.style.fill = colour(row);
      dot.classList.toggle('chosen-dot', row === state.chosen);
      dot.append(draw('title', {}, `${value(row, at.get('name'))}\n${label(x)} ${show(value(row, x))}, ${label(y)} ${show(value(row, y))}`));
      dot.addEventListener('click', () => choose(row));
      svg.append(dot);
    }
    byId('front-words').textContent = front.length
      ? `On the front: ${front.length} of ${there.length} designs, the best in one for what they are in the other.`
      : 'No design that counts has both numbers.';
  };

  // ---- the chosen design, pictures, table ----

  const picture = (row, word) => pictures[row]
    ? make('img', { src: pictures[row], alt: word, width: '213', height: '160' })
    : make('div', { class: 'no-picture' }, 'no picture');

  const drawChosen = () => {
    const card = byId('chosen');
    card.replaceChildren();
    const row = state.chosen;
    if (row < 0) {
      card.append(make('p', { class: 'note' }, 'No point has a design yet.'));
      return;
    }
    const name = value(row, at.get('name'));
    card.append(make('h3', {}, name), picture(row, name));
    const verdict = at.has('verdict') ? value(row, at.get('verdict')) : null;
    if (verdict) card.append(make('p', { class: value(row, pass) ? 'ok' : 'no' }, verdict));
    const path = `points/${value(row, at.get('hash'))}`;
    const where = make('p', { class: 'note' }, 'Run folder: ');
    where.append(make('a', { href: `${path}/` }, path));
    card.append(where);
    const list = make('div', { class: 'numbers', tabindex: '0', role: 'region', 'aria-label': 'all numbers' });
    const table = make('table');
    columns.forEach((column, i) => {
      const cell = value(row, i);
      if (cell === null || ['name', 'hash', 'verdict', 'status'].includes(column.name)) return;
      const line = make('tr');
      line.append(make('td', { title: column.about }, label(i)), make('td', numeric(i) ? { class: 'n' } : {}, show(cell)));
      table.append(line);
    });
    list.append(table);
    card.append(list);
  };

  const MOST = 48;
  const drawGallery = (shown) => {
    const gallery = byId('gallery'), i = at.get(byId('y').value);
    const sorted = shown.slice().sort((a, b) => (value(a, i) ?? Infinity) - (value(b, i) ?? Infinity));
    gallery.replaceChildren();
    for (const row of sorted.slice(0, state.all ? undefined : MOST)) {
      const name = value(row, at.get('name'));
      const button = make('button', { type: 'button', class: 'tile', 'aria-pressed': String(row === state.chosen) });
      const mark = make('span', { class: 'bar-mark' });
      mark.style.background = colour(row);
      button.append(picture(row, ''), mark, make('span', {}, name),
        make('small', {}, `${columns[i].name} ${show(value(row, i))}`));
      button.addEventListener('click', () => choose(row));
      gallery.append(button);
    }
    byId('more').hidden = state.all || sorted.length <= MOST;
    byId('more').textContent = `all ${sorted.length} pictures`;
  };

  const markTable = (shown) => {
    const kept = new Set(shown);
    for (const line of document.querySelectorAll('#table tbody tr')) {
      const row = Number(line.dataset.row);
      line.hidden = designs.includes(row) && !kept.has(row);
      line.classList.toggle('chosen', row === state.chosen);
    }
  };

  const sortTable = (head, index) => {
    const up = head.getAttribute('aria-sort') !== 'ascending';
    for (const each of document.querySelectorAll('#table th')) each.removeAttribute('aria-sort');
    head.setAttribute('aria-sort', up ? 'ascending' : 'descending');
    const body = document.querySelector('#table tbody'), sign = up ? 1 : -1;
    const key = (line) => { const v = value(Number(line.dataset.row), index); return v === null ? undefined : v; };
    const lines = [...body.rows].sort((a, b) => {
      const [p, q] = [key(a), key(b)];
      if (p === undefined || q === undefined) return (p === undefined) - (q === undefined);
      return p < q ? -sign : p > q ? sign : 0;
    });
    body.append(...lines);
  };

  const choose = (row) => { state.chosen = row; refresh(); };

  const refresh = () => {
    const shown = designs.filter(inside);
    drawParallel(shown);
    drawFront(shown);
    drawChosen();
    drawGallery(shown);
    markTable(shown);
    byId('count').textContent = `${shown.length} of ${designs.length} designs`;
    byId('reset').disabled = state.ranges.size === 0;
  };

  const options = (id, names, chosen) => {
    for (const name of names) byId(id).append(make('option', { value: name }, name));
    byId(id).value = chosen;
    byId(id).addEventListener('change', refresh);
  };

  const start = () => {
    const plotted = columns.map((_, i) => i).filter((i) => numeric(i)
      && designs.some((row) => typeof value(row, i) === 'number')).map((i) => columns[i].name);
    byId('colour').append(make('option', { value: 'verdict' }, 'the verdict'));
    options('colour', study.varying, 'verdict');
    options('x', plotted, study.x);
    options('y', plotted, study.y);
    byId('x-better').value = study.x_better;
    for (const id of ['x-better', 'y-better', 'passing']) byId(id).addEventListener('change', refresh);
    byId('passing').checked = designs.some((row) => value(row, pass) === true);
    for (const name of study.varying) {
      const box = make('label'), input = make('input', { type: 'checkbox' });
      const i = at.get(name);
      input.checked = state.axes.includes(i);
      input.addEventListener('change', () => {
        state.axes = input.checked ? [...state.axes, i] : state.axes.filter((each) => each !== i);
        state.ranges.delete(i);
        refresh();
      });
      box.append(input, ` ${label(i)}`);
      byId('axes').append(box);
    }
    byId('reset').addEventListener('click', () => { state.ranges.clear(); refresh(); });
    byId('more').addEventListener('click', () => { state.all = true; refresh(); });
    const step = (by) => {
      const order = state.front?.length ? state.front : designs;
      const k = order.indexOf(state.chosen);
      if (order.length) choose(order[(k + by + order.length) % order.length]);
    };
    byId('front').addEventListener('keydown', (event) => {
      if (event.key !== 'ArrowLeft' && event.key !== 'ArrowRight') return;
      event.preventDefault();
      step(event.key === 'ArrowRight' ? 1 : -1);
    });
    for (const button of document.querySelectorAll('#table td button'))
      button.addEventListener('click', () => choose(Number(button.closest('tr').dataset.row)));
    for (const button of document.querySelectorAll('#table th button'))
      button.addEventListener('click', () => sortTable(button.parentElement, Number(button.dataset.column)));
    document.body.classList.add('live');
    refresh();
  };
  start();
})();
