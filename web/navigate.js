// Pointer and keyboard on the model: orbit, pan, zoom; a press without movement is a click.

export function navigate(canvas, camera, redraw, onClick) {
  const pointers = new Map();
  let travelled = 0;

  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    travelled = 0;
  });

  canvas.addEventListener('pointermove', (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const now = { x: event.offsetX, y: event.offsetY };
    const dx = now.x - before.x, dy = now.y - before.y;
    travelled += Math.abs(dx) + Math.abs(dy);
    if (pointers.size === 2) {
      const [other] = [...pointers].filter(([id]) => id !== event.pointerId).map(([, place]) => place);
      camera.zoom(span(before, other) / Math.max(span(now, other), 1));
      camera.pan(dx / 2, dy / 2);
    } else if (event.shiftKey || event.buttons & 6) camera.pan(dx, dy);
    else if (travelled > 3) camera.orbit(dx, dy);
    pointers.set(event.pointerId, now);
    redraw();
  });

  const release = (event) => {
    const was = pointers.delete(event.pointerId);
    if (was && event.type === 'pointerup' && event.button === 0 && travelled <= 3) onClick(event.offsetX, event.offsetY);
  };
  canvas.addEventListener('pointerup', release);
  canvas.addEventListener('pointercancel', release);
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());

  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 16 : 1;
    camera.zoom(Math.exp(Math.max(-1, Math.min(1, event.deltaY * lines * 0.0015))));
    redraw();
  }, { passive: false });

  canvas.addEventListener('keydown', (event) => {
    const turns = { ArrowLeft: [16, 0], ArrowRight: [-16, 0], ArrowUp: [0, 16], ArrowDown: [0, -16] };
    if (event.key in turns) (event.shiftKey ? camera.pan : camera.orbit).apply(camera, turns[event.key]);
    else if (event.key === '+' || event.key === '=') camera.zoom(0.85);
    else if (event.key === '-') camera.zoom(1 / 0.85);
    else return;
    event.preventDefault();
    redraw();
  });
}

const span = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);
