// The words of the views: the face, the turret, dimensions, comparison. Part of i18n.ts, in a file of its own for its length.

/** Numbers come written as the page shows them: three decimals at most, a true minus. */
export interface ViewStrings {
  readonly views: string;
  readonly view: string;
  readonly section: string;
  readonly face: string;
  readonly both: string;
  readonly faceDrawing: string;
  readonly frontTurret: string;
  readonly frontTurretHint: string;
  readonly keep: string;
  readonly keepHint: string;
  readonly endComparison: string;
  readonly same: string;
  readonly onlyKept: string;
  readonly onlyNow: string;
  readonly largest: (radial: string, z: string, axial: string, x: string) => string;
  // an edge of the part
  readonly cylinder: (diameter: string, length: string) => string;
  readonly faceEdge: (z: string, from: string, to: string) => string;
  readonly taper: (from: string, to: string, length: string, angle: string) => string;
  readonly ratio: (n: string) => string;
  readonly arc: (radius: string) => string;
  readonly threadEdge: (lead: string, major: string, minor: string) => string;
}

export const viewStrings: { readonly en: ViewStrings; readonly zh: ViewStrings; readonly ru: ViewStrings } = {
  en: {
    views: 'Views',
    view: 'View',
    section: 'Section',
    face: 'Face',
    both: 'Both',
    faceDrawing: 'Drawing of the end face, seen from the tailstock: X to the right, C up. Arrow keys move it, plus and minus zoom, F shows all of it.',
    frontTurret: 'Front turret',
    frontTurretHint: 'The turret stands in front of the spindle: X+ is drawn downwards',
    keep: 'Keep this part to compare',
    keepHint: 'Keep this part, then change the program or open another one: the difference is marked and measured',
    endComparison: 'End comparison',
    same: 'Same as the kept part',
    onlyKept: 'only in the kept part',
    onlyNow: 'only in this one',
    largest: (radial, z, axial, x) => `Largest: ${radial} mm in radius at Z${z}; ${axial} mm along Z at X${x}`,
    cylinder: (diameter, length) => `⌀${diameter}, length ${length}`,
    faceEdge: (z, from, to) => `Face at Z${z}, ⌀${from} to ⌀${to}`,
    taper: (from, to, length, angle) => `Taper ⌀${from} to ⌀${to}, length ${length}, ${angle}° to the axis`,
    ratio: (n) => `, 1:${n}`,
    arc: (radius) => `Radius ${radius}`,
    threadEdge: (lead, major, minor) => `Thread, lead ${lead}, ⌀${major} outside, ⌀${minor} inside`,
  },
  zh: {
    views: '视图',
    view: '视图',
    section: '剖面',
    face: '端面',
    both: '两者',
    faceDrawing: '端面图，从尾座方向看：X 向右，C 向上。方向键移动，加减号缩放，F 显示全部。',
    frontTurret: '前置刀架',
    frontTurretHint: '刀架在主轴前方：X+ 向下画',
    keep: '保留此零件用于比较',
    keepHint: '保留此零件，然后修改程序或打开另一个程序：差异会标出并测量',
    endComparison: '结束比较',
    same: '与保留的零件相同',
    onlyKept: '仅保留的零件有',
    onlyNow: '仅当前零件有',
    largest: (radial, z, axial, x) => `最大差异：Z${z} 处半径 ${radial} mm；X${x} 处沿 Z ${axial} mm`,
    cylinder: (diameter, length) => `⌀${diameter}，长 ${length}`,
    faceEdge: (z, from, to) => `端面 Z${z}，⌀${from} 至 ⌀${to}`,
    taper: (from, to, length, angle) => `锥面 ⌀${from} 至 ⌀${to}，长 ${length}，与轴线夹角 ${angle}°`,
    ratio: (n) => `，锥度 1:${n}`,
    arc: (radius) => `圆弧 R${radius}`,
    threadEdge: (lead, major, minor) => `螺纹，导程 ${lead}，大径 ⌀${major}，小径 ⌀${minor}`,
  },
  ru: {
    views: 'Виды',
    view: 'Вид',
    section: 'Разрез',
    face: 'Торец',
    both: 'Оба',
    faceDrawing: 'Чертёж торца, вид со стороны задней бабки: X вправо, C вверх. Стрелки двигают его, плюс и минус меняют масштаб, F показывает всё.',
    frontTurret: 'Передняя револьверная головка',
    frontTurretHint: 'Резцедержатель стоит перед осью шпинделя: X+ направлен вниз',
    keep: 'Запомнить деталь для сравнения',
    keepHint: 'Запомните деталь, затем измените программу или откройте другую: различие будет отмечено и измерено',
    endComparison: 'Закончить сравнение',
    same: 'Как запомненная деталь',
    onlyKept: 'только в запомненной',
    onlyNow: 'только в этой',
    largest: (radial, z, axial, x) => `Наибольшее: ${radial} мм по радиусу при Z${z}; ${axial} мм вдоль Z при X${x}`,
    cylinder: (diameter, length) => `⌀${diameter}, длина ${length}`,
    faceEdge: (z, from, to) => `Торец Z${z}, от ⌀${from} до ⌀${to}`,
    taper: (from, to, length, angle) => `Конус от ⌀${from} до ⌀${to}, длина ${length}, ${angle}° к оси`,
    ratio: (n) => `, 1:${n}`,
    arc: (radius) => `Радиус ${radius}`,
    threadEdge: (lead, major, minor) => `Резьба, ход ${lead}, наружный ⌀${major}, внутренний ⌀${minor}`,
  },
};
