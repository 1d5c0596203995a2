//! The phrases in Chinese.

use super::Phrase;

pub(in crate::sentences) const fn phrase(phrase: Phrase) -> &'static str {
    use Phrase::*;
    match phrase {
        CloseComment => "补上右括号",
        DecimalPoint => "改成小数点",
        LetterO => "改成字母 O",
        Minus => "改成负号",
        Write => "改写为 `{text}`",
        Delete => "删除 `{text}`",
        Insert => "插入 `{text}`",
        AsCycle => "将这四个动作写成 {cycle}",
        AsCyclePasses => "将这 {passes} 刀写成 {cycle}",
        Rapid => "快速移动至 {to}",
        Feed => "切削进给至 {to}",
        ArcClockwise => "圆弧 G02 至 {to}",
        ArcCounterclockwise => "圆弧 G03 至 {to}",
        Thread => "螺纹切削至 {to}",
        Dwell => "暂停于 {to}",
        DwellFor => "在 {to} 暂停 {seconds} 秒",
        Infeed => "进刀",
        Cut => "切削",
        PullOut => "退尾",
        Retract => "退刀",
        Return => "返回",
        Approach => "趋近",
        Escape => "45° 退刀",
        Contour => "沿轮廓",
        Relief => "侧向退刀",
        Stepover => "移位",
        AtRapid => "快速",
        WithSpindle => "随主轴同步",
        AtFeed => "按进给速度",
        Pass => " 第 {pass} 刀",
        PassOf => " 第 {pass} 刀（共 {passes} 刀）",
        OfCycle => "{cycle}{pass}：{manner}{step}至 {to}",
        CutOfCycle => "{cycle}{pass}：{manner}{step}至 {to}",
    }
}
