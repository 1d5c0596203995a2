// A canvas for Node, which takes all that is drawn on it and shows nothing: the module asks for these classes by
// their names.

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

/** Makes them global, as they are in a browser. */
export function installCanvas() {
  Object.assign(globalThis, { OffscreenCanvas, OffscreenCanvasRenderingContext2D, ImageBitmap, Path2D });
}
