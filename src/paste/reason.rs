//! Reasons for corrections, with texts in three languages.

use crate::sentences::Language;

/// Why a piece of text was corrected, omitted, or needs a decision.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Reason {
    /// A full-width character.
    FullWidth,
    /// A typographic dash instead of a minus sign.
    Minus,
    /// A letter instead of a digit: `GO1`, `G0l`.
    LetterForDigit,
    /// A zero instead of the letter O of a program number: `00006`.
    ZeroForO,
    /// A letter of another script that looks like the address letter.
    LookAlike,
    /// A comma or full stop instead of a decimal point.
    DecimalPoint,
    /// A zero-width character.
    Invisible,
    /// Two blocks on one line were split.
    Split,
    /// A bullet, a quotation mark of an e-mail, a table border.
    Bullet,
    /// A line number or a list number.
    LineNumber,
    /// Sequence numbers in a separate column.
    LoneNumbers,
    /// The program number, repeated where a table continues.
    RepeatedHead,
    /// Text after a block, converted to a comment.
    Remark,
    /// Text that is not part of a block.
    Prose,
    /// A format with placeholders: `X(U)_`.
    Format,
    /// Meaningless characters: copy protection of a forum, a page number, a picture.
    Noise,
    /// An unreadable character in the place of a possible minus sign.
    UnreadableSign,
    /// All minus signs seem to be missing.
    LostMinus,
    /// An unreadable character directly after the digits.
    UnreadableDigit,
}

impl Reason {
    /// Every reason.
    pub const ALL: [Reason; 19] = [
        Self::FullWidth,
        Self::Minus,
        Self::LetterForDigit,
        Self::ZeroForO,
        Self::LookAlike,
        Self::DecimalPoint,
        Self::Invisible,
        Self::Split,
        Self::Bullet,
        Self::LineNumber,
        Self::LoneNumbers,
        Self::RepeatedHead,
        Self::Remark,
        Self::Prose,
        Self::Format,
        Self::Noise,
        Self::UnreadableSign,
        Self::LostMinus,
        Self::UnreadableDigit,
    ];

    /// Whether the parser reports the same fault with the same fix.
    pub(super) fn is_parsers_own(self) -> bool {
        matches!(self, Self::Minus | Self::LetterForDigit | Self::ZeroForO | Self::DecimalPoint)
    }

    /// Whether it concerns single characters that no control accepts.
    pub(super) fn is_of_characters(self) -> bool {
        matches!(self, Self::FullWidth | Self::LookAlike | Self::Invisible | Self::Noise)
    }

    /// The explanation in a language.
    pub fn phrase(self, language: Language) -> &'static str {
        match language {
            Language::English => self.english(),
            Language::Chinese => self.chinese(),
            Language::Russian => self.russian(),
        }
    }

    fn english(self) -> &'static str {
        match self {
            Self::FullWidth => "Full-width characters were replaced with plain ones",
            Self::Minus => "A printed dash became a minus",
            Self::LetterForDigit => "A letter stood in place of a digit",
            Self::ZeroForO => "A zero stood in place of the letter O of the program number",
            Self::LookAlike => "A letter of another script stood in place of the address",
            Self::DecimalPoint => "Another character was in place of the decimal point",
            Self::Invisible => "Invisible characters were removed",
            Self::Split => "Several blocks stood on one line",
            Self::Bullet => "A bullet or a table line was left out",
            Self::LineNumber => "A line or list number was left out",
            Self::LoneNumbers => "A column of sequence numbers was left out",
            Self::RepeatedHead => "The program number is repeated where the table goes on",
            Self::Remark => "The text after the block became a comment",
            Self::Prose => "Text that is no block was left out",
            Self::Format => "A format with placeholders was left out",
            Self::Noise => "Stray characters were removed",
            Self::UnreadableSign => "The sign cannot be read; it may have been a minus",
            Self::LostMinus => {
                "No minus is left in this program and the cut would lead away from the part; was this one negative?"
            }
            Self::UnreadableDigit => "What follows it cannot be read; a digit may be lost",
        }
    }

    fn chinese(self) -> &'static str {
        match self {
            Self::FullWidth => "全角字符已改为半角",
            Self::Minus => "印刷破折号已改为负号",
            Self::LetterForDigit => "数字位置上是字母",
            Self::ZeroForO => "程序号的字母 O 被印成了零",
            Self::LookAlike => "地址位置上是其他文字中形状相似的字母",
            Self::DecimalPoint => "小数点位置上是别的符号",
            Self::Invisible => "已去除不可见字符",
            Self::Split => "一行中有几个程序段",
            Self::Bullet => "已去除项目符号或表格线",
            Self::LineNumber => "已去除行号或列表编号",
            Self::LoneNumbers => "已去除单独成列的顺序号",
            Self::RepeatedHead => "表格续页处重复的程序号",
            Self::Remark => "程序段后的文字已改为注释",
            Self::Prose => "不是程序段的文字已去除",
            Self::Format => "带占位符的指令格式已去除",
            Self::Noise => "多余的字符已去除",
            Self::UnreadableSign => "符号无法识别，可能原为负号",
            Self::LostMinus => "本程序中没有负号，切削方向会离开零件；此处原来是负值吗？",
            Self::UnreadableDigit => "其后的字符无法识别，可能缺少数字",
        }
    }

    fn russian(self) -> &'static str {
        match self {
            Self::FullWidth => "Полноширинные знаки заменены обычными",
            Self::Minus => "Печатное тире заменено минусом",
            Self::LetterForDigit => "На месте цифры стояла буква",
            Self::ZeroForO => "Вместо буквы O в номере программы стоял ноль",
            Self::LookAlike => "На месте адреса стояла похожая буква другого алфавита",
            Self::DecimalPoint => "Вместо десятичной точки стоял другой знак",
            Self::Invisible => "Невидимые знаки убраны",
            Self::Split => "В одной строке стояло несколько кадров",
            Self::Bullet => "Маркер списка или линия таблицы убраны",
            Self::LineNumber => "Номер строки или пункта убран",
            Self::LoneNumbers => "Столбец номеров кадров убран",
            Self::RepeatedHead => "Номер программы повторён там, где таблица продолжается",
            Self::Remark => "Текст за кадром стал комментарием",
            Self::Prose => "Текст, не являющийся кадром, убран",
            Self::Format => "Формат с подстановочными знаками убран",
            Self::Noise => "Лишние знаки убраны",
            Self::UnreadableSign => "Знак не читается; возможно, это был минус",
            Self::LostMinus => {
                "В программе нет ни одного минуса, и резание уходило бы от детали; было ли число отрицательным?"
            }
            Self::UnreadableDigit => "То, что стоит за числом, не читается; возможно, потеряна цифра",
        }
    }
}
