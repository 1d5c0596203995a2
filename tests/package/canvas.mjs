// A canvas for Node that accepts all drawing commands and shows nothing. The module looks up these classes by name.

class OffscreenCanvasRenderingContext2D {
  constructor(canvas) {
    this.canvas = canvas;
    return new Proxy(this, {
      get: (own, name) => (name in own || typeof name === 'symbol' ? own[name] : () => measured),
    });
  }
}

const measured = { width: 10, actualBoundingBoxAscent: 8, actualBoundingBoxDescent: 2 };

class OffscreenCanvas {
  constructor(width, height) {
    Object.assign(this, { width, height });
    this.context = new OffscreenCanvasRenderingContext2D(this);
  }

  getContext() {
    return this.context;
  }

  transferToImageBitmap() {
    return new ImageBitmap();
  }
}

class ImageBitmap {}

class Path2D {
  moveTo() {}
  lineTo() {}
  arc() {}
  ellipse() {}
  rect() {}
  closePath() {}
  addPath() {}
}

/** Defines the classes globally, as in a browser. */
export function installCanvas() {
  Object.assign(globalThis, { OffscreenCanvas, OffscreenCanvasRenderingContext2D, ImageBitmap, Path2D });
}
