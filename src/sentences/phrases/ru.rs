//! The phrases in Russian.

use super::Phrase;

pub(in crate::sentences) const fn phrase(phrase: Phrase) -> &'static str {
    use Phrase::*;
    match phrase {
        CloseComment => "Закрыть комментарий",
        DecimalPoint => "Поставить десятичную точку",
        LetterO => "Поставить букву O",
        Minus => "Поставить минус",
        Write => "Написать `{text}`",
        Delete => "Удалить `{text}`",
        Insert => "Вставить `{text}`",
        AsCycle => "Записать эти четыре перемещения циклом {cycle}",
        AsCyclePasses => "Записать эти проходы ({passes}) циклом {cycle}",
        Rapid => "ускоренное перемещение в {to}",
        Feed => "перемещение на подаче в {to}",
        ArcClockwise => "дуга G02 до {to}",
        ArcCounterclockwise => "дуга G03 до {to}",
        Thread => "нарезание резьбы до {to}",
        Dwell => "выдержка в {to}",
        DwellFor => "выдержка {seconds} с в {to}",
        Infeed => "врезание",
        Cut => "резание",
        PullOut => "сбег резьбы",
        Retract => "отвод",
        Return => "возврат",
        Approach => "подход",
        Escape => "отвод под 45°",
        Contour => "проход по контуру",
        Relief => "отвод в сторону",
        Stepover => "смещение",
        AtRapid => "ускоренно",
        WithSpindle => "синхронно со шпинделем",
        AtFeed => "на подаче",
        Pass => ", проход {pass}",
        PassOf => ", проход {pass} из {passes}",
        OfCycle => "{cycle}{pass}: {step} {manner} в {to}",
        CutOfCycle => "{cycle}{pass}: {step} {manner} до {to}",
    }
}
