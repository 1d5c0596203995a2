//! Names of the calculators, of their fields and results, and the faults of entries.
//!
//! In: a calculator, the index of a field, a fault. Out: text in a language.

use super::Language;
use super::labels;
use crate::calculate::{Calculator, Fault, Quantity};
use crate::setup::dialect::FeedMode;
use crate::setup::fields;
use crate::units::Unit;

/// A text in English, Chinese and Russian.
type Text = [&'static str; 3];

/// The texts of a calculator, in the order of its fields, results and columns.
struct Texts {
    name: &'static str,
    title: Text,
    fields: &'static [Text],
    results: &'static [Text],
    columns: &'static [Text],
}

const END_X: Text = ["X at the end of the cut", "切削终点的 X", "X конца прохода"];
const END_Z: Text = ["Z at the end of the cut", "切削终点的 Z", "Z конца прохода"];
const START_X: Text = ["X of the start point", "循环起点的 X", "X начальной точки"];
const START_Z: Text = ["Z of the start point", "循环起点的 Z", "Z начальной точки"];
const POINT_X: Text = ["X of a point of the taper", "锥面上一点的 X", "X точки конуса"];
const POINT_Z: Text = ["Z of this point", "该点的 Z", "Z этой точки"];
const PITCH: Text = ["pitch", "螺距", "шаг"];
const LEAD: Text = ["lead", "导程", "ход"];
const PASS: Text = ["pass", "走刀", "проход"];
const PASSES: Text = ["number of passes", "走刀次数", "число проходов"];
const DIAMETER: Text = ["diameter", "直径", "диаметр"];
const SPINDLE: Text = ["spindle speed", "主轴转速", "частота вращения"];
const DEPTH: Text = ["depth of the pass", "每次切深", "глубина прохода"];
const HALF_ANGLE: Text = ["angle to the axis", "圆锥半角", "угол уклона"];

const TEXTS: [Texts; 13] = [
    Texts {
        name: "cone",
        title: ["Taper of a cone", "圆锥的锥度", "Конусность"],
        fields: &[
            ["large diameter", "大端直径", "больший диаметр"],
            ["small diameter", "小端直径", "меньший диаметр"],
            ["length", "长度", "длина"],
        ],
        results: &[["taper", "锥度", "конусность"], HALF_ANGLE, ["cone angle", "圆锥角", "угол конуса"]],
        columns: &[],
    },
    Texts {
        name: "r-of-g90",
        title: ["R of G90", "G90 的 R", "R цикла G90"],
        fields: &[POINT_X, POINT_Z, END_X, END_Z, START_Z],
        results: &[
            ["radius at B minus radius at C", "B 点半径减 C 点半径", "радиус в B минус радиус в C"],
            ["X at the start of the cut, B", "切削起点 B 的 X", "X начала прохода, B"],
        ],
        columns: &[],
    },
    Texts {
        name: "r-of-g94",
        title: ["R of G94", "G94 的 R", "R цикла G94"],
        fields: &[POINT_X, POINT_Z, END_X, END_Z, START_X],
        results: &[
            ["Z at B minus Z at E", "B 点的 Z 减 E 点的 Z", "Z в B минус Z в E"],
            ["Z at the start of the cut, B", "切削起点 B 的 Z", "Z начала прохода, B"],
        ],
        columns: &[],
    },
    Texts {
        name: "passes-of-a-cone",
        title: ["Passes of a cone with G94", "用 G94 分层车锥面", "Проходы при точении конуса циклом G94"],
        fields: &[
            START_X,
            END_X,
            END_Z,
            ["R of the last pass", "最后一次走刀的 R", "R последнего прохода"],
            PASSES,
        ],
        results: &[
            ["step along Z, route 2", "路线 2 沿 Z 的移动量", "шаг вдоль Z, способ 2"],
            ["depth at right angles to the cone", "垂直于锥面的切深", "глубина по нормали к конусу"],
            HALF_ANGLE,
        ],
        columns: &[
            PASS,
            ["route 1: R", "路线 1：R", "способ 1: R"],
            ["depth at B", "B 处切深", "глубина в B"],
            ["depth at E", "E 处切深", "глубина в E"],
            ["route 2: Z", "路线 2：Z", "способ 2: Z"],
            ["depth at B and E", "B、E 处切深", "глубина в B и E"],
        ],
    },
    Texts {
        name: "thread-speed",
        title: [
            "Highest speed of a thread",
            "车螺纹的最高主轴转速",
            "Наибольшая частота вращения для резьбы",
        ],
        fields: &[PITCH, ["safety margin, usually 80", "保险系数，一般取 80", "запас, обычно 80"]],
        results: &[SPINDLE],
        columns: &[],
    },
    Texts {
        name: "run-in",
        title: ["Run-in and run-out of a thread", "螺纹的引入与引出距离", "Путь разгона и путь торможения"],
        fields: &[
            SPINDLE,
            LEAD,
            ["permitted error of the lead", "允许的导程误差", "допускаемая погрешность хода"],
        ],
        results: &[["run-in", "引入距离", "путь разгона"], ["run-out", "引出距离", "путь торможения"]],
        columns: &[],
    },
    Texts {
        name: "thread-height",
        title: ["Height of a thread with 60°", "60° 螺纹的牙型高度", "Высота профиля резьбы с углом 60°"],
        fields: &[["nominal diameter", "公称直径", "номинальный диаметр"], PITCH],
        results: &[
            [
                "height outside, rounded root",
                "外螺纹牙型高度，圆弧牙底",
                "высота профиля наружной резьбы, закруглённая впадина",
            ],
            ["X of the last pass", "最后一次走刀的 X", "X последнего прохода"],
            [
                "height outside, flat root",
                "外螺纹牙型高度，平牙底",
                "высота профиля наружной резьбы, плоская впадина",
            ],
            ["X of the last pass", "最后一次走刀的 X", "X последнего прохода"],
            ["height inside", "内螺纹牙型高度", "высота профиля внутренней резьбы"],
            ["bore before the thread", "螺纹底孔直径", "диаметр отверстия под резьбу"],
        ],
        columns: &[],
    },
    Texts {
        name: "thread-by-name",
        title: ["Thread by name", "按螺纹代号查尺寸", "Резьба по обозначению"],
        fields: &[
            ["M, UN, G, NPT or Tr", "M、UN、G、NPT 或 Tr", "M, UN, G, NPT или Tr"],
            START_Z,
            ["end of the thread, Z", "螺纹终点 Z", "конец резьбы, Z"],
        ],
        results: &[
            ["major diameter", "大径", "наружный диаметр"],
            PITCH,
            LEAD,
            ["thread angle", "牙型角", "угол профиля"],
            ["height outside", "外螺纹牙型高度", "высота профиля наружной резьбы"],
            [
                "core diameter at Z: X of the last pass",
                "Z 处的牙底直径：最后一次走刀的 X",
                "диаметр по впадинам на Z: X последнего прохода",
            ],
            ["height inside", "内螺纹牙型高度", "высота профиля внутренней резьбы"],
            ["bore before an inside thread", "内螺纹底孔直径", "диаметр отверстия под резьбу"],
        ],
        columns: &[],
    },
    Texts {
        name: "passes-of-g76",
        title: ["Passes of G76", "G76 的各次走刀", "Проходы G76"],
        fields: &[
            ["core diameter, X", "牙底直径 X", "X впадины резьбы"],
            ["end of the thread, Z", "螺纹终点 Z", "конец резьбы, Z"],
            START_Z,
            ["height of the thread", "牙型高度", "высота профиля"],
            ["depth of the first pass", "第一次切深", "глубина первого прохода"],
            ["least depth", "最小切深", "наименьшая глубина резания"],
            ["finishing allowance", "精加工余量", "чистовой припуск"],
            ["angle of the tool", "刀尖角", "угол инструмента"],
            LEAD,
        ],
        results: &[PASSES, ["crest diameter", "牙顶直径", "наружный диаметр"]],
        columns: &[
            PASS,
            ["total depth", "累计切深", "общая глубина"],
            ["X of the pass", "该刀的 X", "X прохода"],
            ["Z at its start", "该刀起点的 Z", "Z начала прохода"],
        ],
    },
    Texts {
        name: "passes-of-g71",
        title: ["Passes of G71", "G71 的走刀次数", "Проходы G71"],
        fields: &[
            ["X of the start point, A", "循环起点 A 的 X", "X начальной точки A"],
            ["X at the start of the contour, A′", "轮廓起点 A′ 的 X", "X начала контура A′"],
            DEPTH,
        ],
        results: &[
            ["roughing passes", "粗车走刀次数", "число черновых проходов"],
            ["left for the cut along the contour", "沿轮廓走刀的切深", "остаётся на проход вдоль контура"],
        ],
        columns: &[],
    },
    Texts {
        name: "steps-of-g73",
        title: ["Passes of G73", "G73 的总退刀量与移动量", "Проходы G73"],
        fields: &[
            ["diameter of the blank", "毛坯直径", "диаметр заготовки"],
            ["smallest diameter of the contour", "轮廓的最小直径", "наименьший диаметр контура"],
            PASSES,
        ],
        results: &[
            ["relief along X, radius", "X 向总退刀量（半径值）", "сдвиг первого прохода по X, на радиус"],
            ["step of a pass", "每刀的移动量", "шаг между проходами"],
        ],
        columns: &[],
    },
    Texts {
        name: "columns-of-g75",
        title: ["Columns of G75", "G75 的列数", "Врезания G75"],
        fields: &[
            [
                "Z from the first to the last infeed",
                "第一列到最后一列的 Z 向距离",
                "Z от первого до последнего врезания",
            ],
            ["shift between infeeds", "相邻两列的移动量", "смещение между врезаниями"],
            ["width of the insert", "刀片宽度", "ширина пластины"],
        ],
        results: &[
            ["infeeds", "列数", "число врезаний"],
            ["overlap", "重叠量", "перекрытие"],
            ["width of the groove", "槽宽", "ширина канавки"],
        ],
        columns: &[],
    },
    Texts {
        name: "speed",
        title: ["Spindle speed and roughness", "主轴转速与表面粗糙度", "Частота вращения и шероховатость"],
        fields: &[
            ["cutting speed", "切削速度", "скорость резания"],
            DIAMETER,
            ["feed per revolution", "每转进给", "подача на оборот"],
            ["nose radius", "刀尖圆弧半径", "радиус при вершине"],
        ],
        results: &[SPINDLE, ["theoretical roughness", "理论粗糙度", "теоретическая шероховатость"]],
        columns: &[],
    },
];

fn of(calculator: &Calculator) -> &'static Texts {
    let found = TEXTS.iter().find(|texts| texts.name == calculator.name);
    found.unwrap_or(&TEXTS[0])
}

fn among(texts: &[Text], at: usize, language: Language) -> &'static str {
    texts.get(at).map_or("", |text| language.among(*text))
}

/// The title of a calculator.
pub fn title(calculator: &Calculator, language: Language) -> &'static str {
    language.among(of(calculator).title)
}

/// The meaning of a field.
pub fn field(calculator: &Calculator, at: usize, language: Language) -> &'static str {
    among(of(calculator).fields, at, language)
}

/// The meaning of a result.
pub fn result(calculator: &Calculator, at: usize, language: Language) -> &'static str {
    among(of(calculator).results, at, language)
}

/// The meaning of a column of the table of passes.
pub fn column(calculator: &Calculator, at: usize, language: Language) -> &'static str {
    among(of(calculator).columns, at, language)
}

/// The unit of a value; empty for a number without one.
pub fn unit(quantity: Quantity, unit: Unit, language: Language) -> &'static str {
    match quantity {
        Quantity::Diameter | Quantity::Length => labels::length(unit, language),
        Quantity::PerTurn => labels::feed_unit(FeedMode::PerTurn, unit, language),
        Quantity::Degrees => "°",
        Quantity::Speed => labels::unit(fields::Unit::TurnsPerMinute, language),
        Quantity::CuttingSpeed => labels::surface_speed(unit, language),
        Quantity::Roughness => language.among(["µm", "µm", "мкм"]),
        Quantity::Number | Quantity::ThreadName => "",
    }
}

/// The meaning of the row with the standard.
pub fn standard(language: Language) -> &'static str {
    language.among(["standard", "标准", "стандарт"])
}

/// Why the value of a field is wrong.
pub fn fault(fault: Fault, language: Language) -> &'static str {
    language.among(match fault {
        Fault::NotANumber => ["Enter a number.", "请输入数字。", "Введите число."],
        Fault::NotPositive => ["It must be greater than 0.", "必须大于 0。", "Должно быть больше 0."],
        Fault::Negative => ["It must not be negative.", "不能为负数。", "Не должно быть отрицательным."],
        Fault::TooFew => ["It must be at least 2.", "至少为 2。", "Должно быть не меньше 2."],
        Fault::NotWhole => ["It must be a whole number.", "必须是整数。", "Должно быть целым числом."],
        Fault::SamePlace => [
            "It equals another value, so there is no taper or cut.",
            "与另一个值相同，没有锥面或切削。",
            "Совпадает с другим значением: нет ни конуса, ни прохода.",
        ],
        Fault::TooMany => ["That makes too many passes.", "走刀次数过多。", "Проходов слишком много."],
        Fault::UnknownThread => [
            "No table of a standard has this thread. Examples: M30×2, 1/4-20 UNC, G1/2, 1/2-14 NPT, Tr40×7.",
            "标准表中没有此螺纹。例：M30×2、1/4-20 UNC、G1/2、1/2-14 NPT、Tr40×7。",
            "Такой резьбы нет в таблицах стандартов. Примеры: M30×2, 1/4-20 UNC, G1/2, 1/2-14 NPT, Tr40×7.",
        ],
        Fault::TooLarge => [
            "It is too large for the other values.",
            "相对于其他值过大。",
            "Слишком велико для остальных значений.",
        ],
        Fault::TooSmall => [
            "It is too small for the other values.",
            "相对于其他值过小。",
            "Слишком мало для остальных значений.",
        ],
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::calculate::{ALL, THREAD};

    #[test]
    fn every_field_result_and_column_has_a_text() {
        for (own, texts) in ALL.iter().zip(&TEXTS) {
            assert_eq!(own.name, texts.name, "the same order");
            let examples: Vec<f64> = own.fields.iter().map(|field| field.example).collect();
            let outcome = own.compute(&examples, THREAD).expect("results");
            let counts = [own.fields.len(), outcome.results.len(), outcome.columns.len()];
            assert_eq!(
                [texts.fields.len(), texts.results.len(), texts.columns.len()],
                counts,
                "{}",
                own.name
            );
        }
        assert_eq!(ALL.len(), TEXTS.len());
    }
}
