//! The messages in Chinese, with the terms of the FANUC and GSK manuals.

use super::{Sentence, end_of, number};
use crate::control::macros::FaultKind;
use crate::control::origin::Origin;
use crate::diagnostics::message::Message;
use crate::motion::{Motion, MotionKind, Step};

pub(super) fn sentence(message: &Message) -> Sentence {
    match message {
        Message::NumberMissing { address } => Sentence::new(format!("地址 `{address}` 后面没有数值。"))
            .help("每个地址后面都要有数值。注释要写在括号里：`( … )`。"),
        Message::AddressMissing { number } => Sentence::new(format!("数值 `{number}` 前面缺少地址。"))
            .help("请在前面补上对应的地址，如 X、Z 或 F。"),
        Message::NotUnderstood { text } => Sentence::new(format!("`{text}` 不属于任何指令字。"))
            .help("是不是抄错或漏掉了字符？注释要写在括号里：`( … )`。"),
        Message::PlainText { text } => Sentence::new(format!("`{text}` 是普通文字，不是程序段。"))
            .help("系统读到这里会报警。说明文字要写在括号里：`( … )`。"),
        Message::SecondPoint { word } => {
            Sentence::new(format!("`{word}` 中有两个小数点。")).help("请核对数值，删去多余的小数点。")
        }
        Message::TooManyDigits { word } => Sentence::new(format!("`{word}` 的数值超过 8 位。"))
            .help("系统最多接受 8 位数字，小数部分也计算在内。"),
        Message::BlankInNumber { written, joined } => {
            Sentence::new(format!("`{written}` 的数值中间有空格，系统会读成 `{joined}`。"))
                .help("请删去空格；如果是漏了地址，请补上。")
        }
        Message::LetterForDigit { word, digit, .. } => {
            Sentence::new(format!("`{word}` 中该写数字 {digit} 的地方写成了字母。"))
                .help("字母 O 与数字 0、字母 l 与数字 1 看上去很像，但系统会区分。")
        }
        Message::ZeroForO { number } => {
            Sentence::new(format!("`{number}` 已按程序号读取：第一个字符应为字母 O。"))
                .help("程序号以字母 O 开头，不是数字 0。")
        }
        Message::PrintedMinus => Sentence::new("这是印刷用的横线，不是负号；这里已按负号读取。")
            .help("系统不认识这个字符，请改成 `-`。"),
        Message::CommaForPoint { word, .. } => {
            Sentence::new(format!("`{word}` 中该写小数点的地方写成了逗号。"))
                .help("G 代码的小数点是 `.`，不能用逗号代替。")
        }
        Message::CommentOpen => Sentence::new("括号没有闭合，本行余下的内容都当作注释。")
            .help("请用 `)` 结束注释，否则系统可能把后面的程序段也当成注释。"),
        Message::CommentNested => Sentence::new("注释里又出现了括号。")
            .help("系统读到第一个 `)` 就认为注释结束，后面的内容会当成指令字。"),
        Message::TextAfterSemicolon { text } => Sentence::new(format!("`;` 后面的 `{text}` 已当作注释。"))
            .help("在 FANUC 和 GSK 系统上，`;` 表示程序段结束；注释要写在括号里：`( … )`。"),
        Message::BlockTooLong { most } => Sentence::new(format!("这个程序段的指令字超过 {most} 个。"))
            .help("是不是漏了换行？程序段余下的内容没有读取。"),
        Message::TextTooLong { bytes, most } => {
            Sentence::new(format!("程序有 {bytes} 字节，这里最多读取 {most} 字节。"))
                .help("请把程序拆开，或只打开要看的部分。")
        }
        Message::EmptyProgram => {
            Sentence::new("还没有程序。").help("请输入或粘贴程序，也可以从示例库中选一个。")
        }
        Message::ProgramNumberZero => Sentence::new("O0 不能用作程序号。").help("程序号的范围是 O1～O9999。"),
        Message::DuplicateProgram { number } => Sentence::new(format!("程序号 O{number} 在这里重复出现。"))
            .help("同一个程序号，系统只能存一个程序。"),
        Message::NoEnd => Sentence::new("程序结尾没有 M30 或 M02。")
            .help("请在结尾写上 M30：否则系统报警停止时，主轴还在转，冷却液也没有关。"),
        Message::MoreMessages { hidden } => Sentence::new(format!("还有 {hidden} 条提示没有显示。"))
            .help("请先改正前面的错误，后面的往往由它们引起。"),
        Message::TooManyMotions { most } => {
            Sentence::new(format!("程序的刀具运动超过 {most} 段，其余没有显示。"))
                .help("是不是循环中的某个量写得太小了？")
        }
        Message::TooMuchWork { most } => Sentence::new(format!(
            "各循环的计算超过 {most} 步，后面的内容没有显示。"
        ))
        .help("G70～G73 每调用一次都要重新读取精加工路线。请减少对长路线的调用，并改正不能执行的循环。"),
        Message::Stopped { seconds } => {
            Sentence::new(format!("运行 {} 秒后被中止，后面的内容没有显示。", number(*seconds)))
        }
        Message::CallNoNumber { code } => Sentence::new(format!("{code} 没有指明调用哪个程序。"))
            .help("P 为程序号：M98 P1000 调用 O1000，M98 P1000 L3 调用三次。"),
        Message::ProgramNotFound { word } => {
            Sentence::new(format!("文本中没有 `{word}` 所指的程序，该调用被跳过。"))
                .help("子程序写在主程序之后：O 加程序号、程序段、M99。没有 L 时，最后四位之前的数字为重复次数：P51002 即 O1002 调用五次。")
        }
        Message::SequenceNotFound { sequence } => {
            Sentence::new(format!("本程序中没有顺序号 N{sequence}，该跳转被跳过。")).help("只在所在的 O 程序内检索。")
        }
        Message::CallTooDeep { most, .. } => Sentence::new(format!("调用嵌套超过 {most} 层，运行在此结束。"))
            .help("程序调用自身，或两个程序互相调用，永远不会结束。"),
        Message::NoReturn => Sentence::new("该子程序结尾没有 M99。").help("系统在此报警停止；图形从调用处之后继续。"),
        Message::EndlessMain => Sentence::new("主程序中的 M99 返回程序开头，无限循环；图中只画一遍。")
            .help("自动送料加工常这样写。作为子程序由 M98 调用时，则返回调用它的程序。结束程序请写 M30。"),
        Message::TooManyRepeats { most } => {
            Sentence::new(format!("从这里起，跳转、循环和调用执行的程序段超过 {most} 段，运行结束。"))
                .help("循环没有终点，或次数太多。请检查循环条件、计数变量或调用的 L。")
        }
        Message::TooMuchRepeated { most } => {
            Sentence::new(format!("从这里起，跳转、循环和调用执行的程序段超过 {most} 个字符，运行结束。"))
                .help("循环没有终点，或很长的程序段重复次数太多。请检查循环条件、计数变量或调用的 L。")
        }
        Message::TooManyRounds { most } => {
            Sentence::new(format!("循环和调用的次数超过 {most} 次，运行在此结束。"))
                .help("请检查该循环靠什么结束：条件、计数变量或调用的 L。")
        }
        Message::TooManyMacroSteps { most } => {
            Sentence::new(format!("跳转、循环和调用中计算的宏语句和表达式超过 {most} 个，运行在此结束。"))
                .help("请检查循环靠什么结束，或减少每次循环中的计算。")
        }
        Message::NotRun { number } => Sentence::new(format!("O{number:04} 没有运行：没有程序调用它。"))
            .help("文本中有多个程序时运行第一个。可选择另一个程序查看。"),
        Message::NumberFromVariable { word } => Sentence::new(format!("`{word}`：N 和 O 的号码不能用变量给出。"))
            .help("请直接写出号码。GOTO、P、Q 可以用变量指定。"),
        Message::Macro { kind } => macro_fault(*kind),
        Message::MacroAlarm { number, words } => Sentence::new(format!("程序自身发出报警 {number}：{words}"))
            .help("#3000 由程序发出报警，多用于检查数据：请查看它之前的条件和调用时的自变量。"),
        Message::SystemVariable { variable } => {
            Sentence::new(format!("#{variable} 是这里未知的机床系统变量，读作空值。")).help("与它有关的图形可能不正确。")
        }
        Message::Foreign { origin: Origin::Mill } => Sentence::new("这像是铣床程序。")
            .help("本页面读取 FANUC 和 GSK 车床程序，没有运行。若要照样运行，请在设置中把 `recognise` 设为 false。"),
        Message::Foreign { origin: Origin::Printer } => Sentence::new("这像是 3D 打印机程序。")
            .help("本页面读取 FANUC 和 GSK 车床程序，没有运行。若要照样运行，请在设置中把 `recognise` 设为 false。"),
        Message::Foreign { origin } => Sentence::new(format!("这像是 {} 的程序，这里不支持。", origin.name()))
            .help("同样的代码在那里含义不同，因此没有运行。本页面读取 FANUC 和 GSK 车床程序。若要照样运行，请在设置中把 `recognise` 设为 false。"),
        Message::SystemGuessed { system } => {
            Sentence::new(format!("按 G 代码体系 {system:?} 读取：该指令不属于体系 A。"))
                .help("体系 B 和 C 中，G90、G91 为绝对和增量，G92 设定坐标系或最高转速，G77 G78 G79（B）为循环。可在设置中指定体系。")
        }
        Message::ReferenceNumber { word } => Sentence::new(format!("`{word}` 不是参考点号：G30 用 P2、P3 或 P4。")),
        Message::NotAtReference { x, z } => {
            Sentence::new(format!("G27 的终点不是参考点，这里参考点为 X{} Z{}。", number(*x), number(*z)))
                .help("G27 检查刀具是否到达参考点，未到达则报警。")
        }
        Message::NoIntermediate => Sentence::new("G29 没有中间点：之前没有 G28 或 G30。"),
        Message::MachineZero { x, z } => {
            Sentence::new(format!("G53 以机床零点计算；这里取参考点 X{} Z{} 为机床零点。", number(*x), number(*z)))
                .help("机床零点的位置只有机床知道。请在设置的 `refPoint` 中填写回零后的位置。")
        }
        Message::OffsetNumber { word } => Sentence::new(format!("`{word}` 不是偏置表中的号码。")),
        Message::TipNumber { word } => Sentence::new(format!("`{word}` 不是刀尖方位号：应为 0 到 9。")),
        Message::DataPassedOver => Sentence::new("从这里到 G11 是写入系统数据表的数据，被跳过。"),
        Message::HoleInForce { word, hole, .. } => Sentence::new(format!("{hole} 有效时不能写 `{word}`。"))
            .help("先写 G80：在此之前每个 X、Z 或 C 都会再加工一个孔。"),
        Message::PeckZero { word } => Sentence::new(format!("`{word}` 不是有效的每次切深。"))
            .help("Q 是每次啄钻的深度，单位微米，例如 Q5000。不写 Q 则一次钻到底。"),
        Message::HoleNoDepth { code } => Sentence::new(format!("{code} 没有孔深。"))
            .help("G83 G84 G85 用 Z 或 W，G87 G88 G89 用 X 或 U 给出孔底。"),
        Message::HoleOfOthers { code } => Sentence::new(format!("FANUC 体系 A 没有 {code}；按有此代码的车床画出。"))
            .help("从起点沿 Z 钻孔并退回。FANUC 车床系统用 G83 或 G74 钻孔。"),
        Message::MakerG { word } => Sentence::new(format!("`{word}` 因机床而异，被跳过。"))
            .help("这类号码由机床厂自定，其动作没有画出。"),
        Message::UnknownG { word } => {
            Sentence::new(format!("`{word}` 不是本系统的 G 代码。")).help("整个程序段都不执行，请核对代码。")
        }
        Message::UnknownM { word } => Sentence::new(format!("`{word}` 只在部分机床上有效，这里跳过不执行。"))
            .help("它的功能请查机床厂家的说明书。"),
        Message::NotSupported { what } => Sentence::new(format!("这里不支持 {what}。"))
            .help("这不是程序的错。此后的刀具轨迹可能不准确，用淡色画出。"),
        Message::PointNotAllowed { word } => Sentence::new(format!("`{word}` 必须是整数，不能带小数点。")),
        Message::MinusNotAllowed { word } => Sentence::new(format!("`{word}` 不能是负值。")),
        Message::DuplicateWord { address, used } => {
            Sentence::new(format!("地址 {address} 在本程序段中出现了两次，以 `{used}` 为准。"))
                .help("系统会取后一个，或者报警。请删去写错的那个。")
        }
        Message::SameGroup { dropped, used } => {
            Sentence::new(format!("`{dropped}` 与 `{used}` 不能同时有效，以 `{used}` 为准。"))
                .help("两者属于同一个模态组，同一程序段中最后一个有效。")
        }
        Message::AbsoluteAndIncremental { absolute, incremental, used } => {
            Sentence::new(format!("`{absolute}` 与 `{incremental}` 指定的是同一个轴，以 `{used}` 为准。"))
                .help("各系统的处理不同：FANUC 取后写的，GSK 取绝对坐标。")
        }
        Message::ToolWithSetting { word } => {
            Sentence::new(format!("`{word}` 不能与 G50、G10 或 G04 写在同一程序段。"))
                .help("请把换刀单独写成一个程序段。")
        }
        Message::ShortTool { word, offset } => {
            Sentence::new(format!("`{word}` 没有写刀号：只调用 {offset} 号刀补，刀架不转位。"))
                .help("在四位数 T 代码的系统上要写全刀号和刀补号，如 T0101。")
        }
        Message::ToolNumber { word } => {
            Sentence::new(format!("`{word}` 不是有效的 T 代码。")).help("请写刀号和刀补号，如 T0101。")
        }
        Message::G90AsAbsolute => Sentence::new("车床上的 G90 是外圆切削循环，不是绝对值编程。").help(
            "车床上 X、Z 总是绝对坐标，U、W 总是增量坐标。留着 G90，下一个 X 或 Z 就会启动循环：请删去 G90。",
        ),
        Message::LetterIInG92 { as_taper } => {
            let reading = if *as_taper { "锥度（同 R）" } else { "每英寸牙数" };
            Sentence::new(format!("G92 中的 I 已按{reading}读取。"))
                .help("FANUC 把 I 当作锥度（R 的旧写法），GSK 把 I 当作每英寸牙数。")
        }
        Message::G28NoAxis => {
            Sentence::new("G28 没有指定轴，刀具不动。").help("要让两轴都返回参考点，请写 G28 U0 W0。")
        }
        Message::DwellNoTime => {
            Sentence::new("G04 没有写时间，不会暂停。").help("请用 X 或 U 指定秒数，或用 P 指定毫秒数。")
        }
        Message::AxisNotHere { word } => Sentence::new(format!("这里不支持 `{word}` 的 Y 轴：只画 X、Z 和 C。"))
            .help("X 和 Z 的运动照常画出，此后以淡色表示。只提示一次。"),
        Message::PlaneNotHere { word } => Sentence::new(format!("这里不支持 G12.1 以外 {word} 平面的圆弧。"))
            .help("车削用 G18；端面铣圆弧写在 G12.1 之内。只提示一次。"),
        Message::CAxisNotConnected => Sentence::new("这里 C 轴运动，但之前没有连接 C 轴。")
            .help("所用代码因机床而异，例如 M45 和 G28 H0。主轴方式下使用 C 会报警。"),
        Message::LiveToolStopped => Sentence::new("这里用动力刀具切削，但之前没有启动动力刀具。")
            .help("所用代码因机床而异，例如 M13 或 M14 加 S。"),
        Message::PolarForbidden { word } => Sentence::new(format!("G12.1 与 G13.1 之间不允许使用 `{word}`。"))
            .help("其间只能使用 G01 G02 G03 G04 G40 G41 G42 G65 G66 G67 G98 G99：用 G01 接近，或先用 G13.1 取消。"),
        Message::PolarFrame { word } => Sentence::new(format!("`{word}` 在 G12.1 与 G13.1 之间改变了坐标系。"))
            .help("请在 G12.1 之前设定零点：X0 必须是主轴中心。"),
        Message::PolarNotAlone { code, other } => {
            Sentence::new(format!("{code} 必须单独一段，不能与 `{other}` 同段。")).help("把其他指令移到另一段。")
        }
        Message::PlaneCompensation { code } => Sentence::new(format!("{code} 处于 G41 或 G42 方式中。"))
            .help("补偿要在方式内部建立和取消：在 G12.1 或 G07.1 C… 之后建立，在 G13.1 或 G07.1 C0 之前用 G40 取消。"),
        Message::PolarFeedPerTurn => Sentence::new("极坐标插补中不能用每转进给（G99）。")
            .help("此时主轴只作定位：请写 G98，F 单位为 mm/min。"),
        Message::PolarNoRadius => Sentence::new("这里 G41 或 G42 没有刀具半径，不起补偿作用。")
            .help("在刀具的偏置中填入半径，刀具中心即与轨迹保持该距离。"),
        Message::PolarAngle { word } => Sentence::new(format!("`{word}` 像是角度；在 G12.1 与 G13.1 之间 C 是长度，单位 mm。"))
            .help("轨迹写在平面内：X 向右，为直径值；C 向上，单位 mm。"),
        Message::PolarCenter { distance } => {
            Sentence::new(format!("轨迹距主轴中心仅 {} mm，C 轴转速将趋于无限大。", number(*distance)))
                .help("系统会在此减速或报警。请远离中心。")
        }
        Message::PlaneLeftOn { code, off } => Sentence::new(format!("到 `{code}` 时带 C 轴的插补仍然有效。"))
            .help(format!("之前请单独一段写 {off}。")),
        Message::CylinderFormat => Sentence::new("G07.1 需要用 C 给出圆柱半径，且不能有其他指令。")
            .help("G07.1 C30 以半径 30 mm 开始，G07.1 C0 结束；不能重复开始。"),
        Message::CylinderForbidden { word } => Sentence::new(format!("圆柱插补中不允许使用 `{word}`。"))
            .help("其间只能使用 G01 至 G04 和 G40 至 G42，圆弧用 R 给出，快速移动写在 G07.1 之前或 G07.1 C0 之后。"),
Message::DwellWithPoint { word } => Sentence::new(format!("`{word}` 带小数点，按秒读取。"))
            .help("FANUC 的 P 为毫秒，不带小数点，否则报警；Haas 读作秒。用 X 或 U 在各种系统上都是秒。"),
                Message::FeedMissing => Sentence::new("没有进给速度：切削之前没有给出不为零的 F。")
            .help("刚开机时系统在此报警；否则按前一个程序的 F 切削。请加上 F，如 G99 时写 F0.2（mm/r），G98 时写 F200（mm/min）。"),
        Message::LeadMissing { code } => Sentence::new(format!("{code} 没有给出导程。"))
            .help("F 指定螺纹导程，单位 mm；单线螺纹的导程就是螺距。"),
        Message::FeedUnit { feed, per_turn: true } => {
            let feed = number(*feed);
            Sentence::new(format!("G99 状态下，F{feed} 是主轴每转进给 {feed} mm。"))
                .help("这样的进给量太大，无法切削。是不是要用 G98（mm/min）？请改系统的进给方式，或在程序中写 G98。")
        }
        Message::FeedUnit { feed, per_turn: false } => {
            let feed = number(*feed);
            Sentence::new(format!("G98 状态下，F{feed} 只是每分钟进给 {feed} mm。"))
                .help("是不是要用 G99（mm/r）？请改系统的进给方式，或在程序中写 G99。")
        }
        Message::FeedNotRepeated { feed, per_turn } => {
            let (code, unit) = if *per_turn { ("G99", "mm/r") } else { ("G98", "mm/min") };
            Sentence::new(format!("改用 {code} 后，原来的 F{} 按 {unit} 计算。", number(*feed)))
                .help("改变进给方式后，要重新写 F。")
        }
        Message::SpindleStopped => {
            Sentence::new("主轴没有转，刀具就在切削。").help("切削之前，请先用 M03 或 M04 启动主轴。")
        }
        Message::NoSpeedClamp => Sentence::new("用了 G96 恒线速，却没有限制主轴最高转速。")
            .help("越靠近中心，转速升得越高，没有上限。请先限速，如 G50 S2000。"),
        Message::ClampReversed { lowest, highest } => {
            Sentence::new(format!("主轴最低转速 Q{} 高于最高转速 S{}。", number(*lowest), number(*highest)))
        }
        Message::ThreadAtSurfaceSpeed { code } => {
            Sentence::new(format!("{code} 在 G96 恒线速状态下车螺纹，主轴转速会随 X 变化。"))
                .help("每一刀都要切在同一条螺旋槽里，否则会乱牙：请用 G97 S… 指定固定转速。")
        }
        Message::ArcNoCenter { code } => Sentence::new(format!("{code} 既没有 R，也没有 I、K。"))
            .help("请用 R 给出半径，或用 I、K 给出圆心相对于圆弧起点的坐标；或者本想写 G01？FANUC 在参数未设报警时走直线。"),
        Message::ArcRadiusTooSmall { radius, distance } => {
            Sentence::new(format!("R{} 太小：圆弧起点与终点相距 {} mm。", number(*radius), number(*distance)))
                .help(format!("半径至少要 {} mm，即距离的一半。注意 X 是直径值。", number(distance / 2.0)))
        }
        Message::ArcEndOffCircle { start_radius, end_radius } => Sentence::new(format!(
            "终点不在圆上：圆心到起点是 {} mm，到终点却是 {} mm。",
            number(*start_radius),
            number(*end_radius)
        ))
        .help("I 是圆心相对于起点的 X 向增量（半径值），K 是 Z 向增量，都带正负号。"),
        Message::ArcRadiusNegative { radius } => {
            Sentence::new(format!("本系统不接受 R{}。", number(*radius)))
                .help("大于 180° 的圆弧请用 I、K 编程。")
        }
        Message::ArcNowhere => {
            Sentence::new("圆弧的终点就是起点，用 R 编程时刀具不动。").help("整圆要用 I、K 编程。")
        }
        Message::TaperBeyondStart { taper, limit, axis } => {
            let (part, rule) = if *axis == 'U' { ("的一半", "|U/2|") } else { ("的长度", "|W|") };
            Sentence::new(format!(
                "`R{}` 超过 `{axis}{}` {part}：切削起点会落到循环起点之外。",
                number(*taper),
                number(*limit)
            ))
            .help(format!("R 与 {axis} 的符号不一致时，要求 |R| ≤ {rule}。"))
        }
        Message::TaperNotExtended { taper, needed, crossing, wanted, axis } => Sentence::new(format!(
            "R{} 是图样上的锥度，没有考虑实际的循环起点：锥面与毛坯边缘交于 {axis}{}，而不是 {axis}{}。",
            number(*taper),
            number(*crossing),
            number(*wanted)
        ))
        .help(format!("切削起点在毛坯之外，R 的绝对值要按比例加大：R{}。", number(*needed))),
        Message::ContourNotNamed { code } => Sentence::new(format!("{code} 必须同时写 P 和 Q。"))
            .help("P 是精加工路线第一个程序段的顺序号，Q 是最后一个程序段的顺序号。"),
        Message::ContourNotFound { word } => Sentence::new(format!("找不到 `{word}` 指定的程序段。"))
            .help("P 指定精加工路线的第一段，Q 指定最后一段；两段要在同一个程序中，Q 段在 P 段之后。"),
        Message::ContourFirstBlock { code } => {
            Sentence::new(format!("{code} 精加工路线的第一段没有用 G00 或 G01 移动。"))
                .help("这一段要把刀具从循环起点移到轮廓的起点。")
        }
        Message::ContourIllegal { word } => Sentence::new(format!("`{word}` 不能写在 P 段到 Q 段之间。"))
            .help("精加工路线只能用 G00、G01、G02、G03 编程。这个循环不执行。"),
        Message::ContourReachesOver { code, word, line } => {
            Sentence::new(format!("{code} 的 P、Q 之间包含了其他加工：第 {line} 行的 `{word}`。"))
                .help("请检查顺序号：可能重复，或 Q 指到了很后面的程序段。该循环不执行。")
        }
        Message::ContourCall { word } => Sentence::new(format!("`{word}` 在精加工路线中调用了子程序。"))
            .help("请把移动指令直接写在 P 段到 Q 段之间。这个循环不执行。"),
        Message::ContourBothAxes { code, other } => {
            Sentence::new(format!("{code} 精加工路线的第一段也写了 {other}，但 {other} 向并不移动。"))
                .help("第一段写了两个轴，系统会按类型 II（凹槽）处理。要用类型 I，请删去这个指令字。")
        }
        Message::ContourTypeTwo { code } => {
            Sentence::new(format!("{code} 精加工路线的第一段两轴同时移动，本系统不接受。"))
                .help("没有类型 II（凹槽）功能时，这一段只能移动一个轴。")
        }
        Message::ContourTurnsBack { code, axis, line, .. } => Sentence::new(format!(
            "{code} 的精加工路线在第 {line} 行沿 {axis} 向折返。"
        ))
        .help("类型 I 要求轮廓在 X、Z 两个方向上都单调变化；类型 II（第一段写两个轴）允许切深方向有凹槽。"),
        Message::ContourBeyondStart { code, axis } => {
            Sentence::new(format!("{code} 的精加工路线在 {axis} 向超出了循环起点。"))
                .help("循环起点要选在轮廓之外。")
        }
        Message::ContourNothingToCut { code } => Sentence::new(format!("循环起点与该轮廓之间没有可供 {code} 切削的余量。"))
            .help("轮廓相对循环起点要有深度和长度：除首尾两段外还应有其他程序段。"),
        Message::ContourOpenEnd { word, .. } => {
            Sentence::new(format!("`{word}` 写在精加工路线的最后一段，后面没有移动。"))
                .help("精加工路线不能以倒角、倒圆或终点未定的角度结束。")
        }
        Message::DepthNotPositive { code, depth: None } => Sentence::new(format!(
            "{code} 没有给出背吃刀量。"
        ))
        .help(
            "请在第一个程序段中指定，如 G71 U2 R0.5 或 G72 W2 R0.5。与 P、Q 写在一起的 U、W 是精加工余量。",
        ),
        Message::DepthNotPositive { code, depth: Some(depth) } => {
            Sentence::new(format!("{code} 的背吃刀量 {} 必须大于零。", number(*depth)))
                .help("背吃刀量不带正负号，进刀方向由精加工路线决定。小于 0.001 mm 的位数会被舍去。")
        }
        Message::AllowanceSign { word } => Sentence::new(format!("精加工余量 `{word}` 的方向指向零件内部。"))
            .help("车外圆时 U 为正，车内孔时 U 为负；W 的方向与切削方向相反。"),
        Message::PatternPasses { passes: None } => {
            Sentence::new("G73 没有给出循环次数。").help("请在第一个程序段中用 R 指定，如 G73 U9 W2 R5。")
        }
        Message::PatternPasses { passes: Some(passes) } => {
            Sentence::new(format!("G73 的循环次数不能是 {}。", number(*passes)))
        }
        Message::TooManyPasses { code, most } => {
            Sentence::new(format!("{code} 的刀具运动会超过 {most} 段，循环不执行。"))
                .help("是不是背吃刀量、啄式进给量或第一刀切深写得太小了？不带小数点的数值可能按 μm 计算。")
        }
        Message::PeckNegative { word } => Sentence::new(format!("`{word}` 不能是负值。"))
            .help("啄式进给量和移动量不带正负号，方向由终点坐标决定。"),
        Message::PeckMissing { code, address } => {
            Sentence::new(format!("{code} 在这个轴上有移动，却没有写 {address}。"))
                .help("P 是 X 向每次的移动量（半径值），Q 是 Z 向每次的移动量。")
        }
        Message::ReliefNegative { word } => Sentence::new(format!("这里的让刀量 `{word}` 不能是负值。"))
            .help("让刀方向由每次移动的方向决定。"),
        Message::AmountInMillimetres { word } => Sentence::new(format!("`{word}` 已按 mm（G20 时按英寸）读取。")).help(
            "FANUC 和 GSK 系统的 P、Q 以 μm 为单位，不带小数点：5 mm 写成 5000。单位可用 pqUnit 设定。",
        ),
        Message::ThreadAngle { angle } => {
            Sentence::new(format!("G76 的刀尖角度不能是 {}°。", number(*angle)))
                .help("FANUC 只接受 80、60、55、30、29 和 0 度，写在 P 的最后两位。")
        }
        Message::ThreadLeastDepth { least, height } => {
            Sentence::new(format!("最小切深 {} mm 大于牙型高度 {} mm。", number(*least), number(*height)))
                .help("第一个程序段的 Q 和第二个程序段的 P 都以 μm 为单位。")
        }
        Message::ThreadNoDepth { word } => {
            let what = if *word == 'P' { "牙型高度 P" } else { "第一刀切深 Q" };
            Sentence::new(format!("G76 的{what} 必须大于零。"))
                .help("P 是牙型高度，Q 是第一刀切深，都是半径值，以 μm 为单位。")
        }
        Message::ThreadStartInside { start, crest } => Sentence::new(format!(
            "G76 的循环起点 X{} 没有让开螺纹牙顶 X{}。",
            number(*start),
            number(*crest)
        ))
        .help("每一刀之后刀具都要退回循环起点的 X 坐标，那里不能碰到工件。"),
        Message::CornerNoMove { word } => Sentence::new(format!("`{word}` 后面没有直线移动，无法形成拐角。"))
            .help("下一个程序段要用 G01 移动（`,C` 和 `,R` 也可以用 G02、G03）。"),
        Message::CornerTooLarge { word } => {
            Sentence::new(format!("`{word}` 太大，超过了相邻两段移动的长度。"))
        }
        Message::CornerNone { word } => Sentence::new(format!("`{word}`：这两段移动之间没有拐角。"))
            .help("轨迹是一直向前，或者原路折返。"),
        Message::CornerAxis { word, .. } => Sentence::new(format!("`{word}` 与下一段移动不符。"))
            .help("不带逗号的倒角、倒圆，前后两段要分别沿不同的轴移动；正负号表示下一段的移动方向。"),
        Message::CornerTwice { word, other } => {
            Sentence::new(format!("`{word}` 和 `{other}` 都是倒角指令，一个程序段只能有一个。"))
        }
        Message::CornerInThread { word } => {
            Sentence::new(format!("`{word}`：螺纹切削程序段中不能倒角或倒圆。"))
                .help("请把倒角写在 G01 程序段中。")
        }
        Message::CornerWithCompensation { word } => {
            Sentence::new(format!("`{word}` 写在刀尖半径补偿建立或取消的程序段中。"))
                .help("请把 G40、G41、G42 写在没有倒角的程序段中。")
        }
        Message::CycleWord { code, word } => Sentence::new(format!("`{word}` 不能写在 {code} 程序段中。"))
            .help("轮廓由 P 到 Q 的程序段给出；循环程序段只写 P、Q、U、W 和 F、S、T。"),
        Message::CycleAxis { code, word } => Sentence::new(format!("`{word}`：{code} 只能使用 X、Z 轴。")),
        Message::CyclePlane { code, .. } => {
            Sentence::new(format!("{code} 只能在 G18 平面内使用。")).help("请先写 G18。")
        }
        Message::FinishStart { roughed_x, roughed_z } => Sentence::new(format!(
            "G70 的起点与粗车循环的起点 X{} Z{} 不同。",
            number(*roughed_x),
            number(*roughed_z)
        ))
        .help("第一段和最后一段是快速移动，从别的点出发可能碰到工件。"),
        Message::FinishWithoutRoughing { first, last } => {
            Sentence::new(format!("G70 精车 N{first} 到 N{last} 的轮廓，但没有 G71、G72 或 G73 粗车它。"))
                .help("毛坯是否已接近成品尺寸？或者 P、Q 写错了程序段号？")
        }
        Message::AngleNoPoint { word, .. } => Sentence::new(format!("由 `{word}` 求不出终点。"))
            .help("角度从 +Z 方向起按逆时针计算。两条直线必须相交；只有一条直线时，除角度外还要写 X 或 Z。"),
        Message::CompensationOnArc { code } => Sentence::new(format!("{code} 不能在圆弧上建立或取消补偿。"))
            .help("G40、G41、G42 要写在直线移动的程序段中（G00 或 G01）。"),
        Message::CompensationOvercut { radius, .. } => {
            Sentence::new(format!("刀尖半径 R{} 在这里放不下，会产生过切。", number(*radius)))
                .help("台阶高度、槽宽或内圆弧半径太小，容不下刀尖圆弧。")
        }
        Message::CompensationNoIntersection { radius } => {
            Sentence::new(format!("刀尖半径为 R{} 时，这两段移动补偿后没有交点。", number(*radius)))
        }
        Message::CompensationPlane => {
            Sentence::new("G41 或 G42 有效时，不能切换平面。").help("请先写 G40 取消补偿。")
        }
        Message::LeadRunsOut { lead } => Sentence::new(format!("G34 的导程会变成 {} mm。", number(*lead)))
            .help("K 是主轴每转的导程增减量，直到终点导程都必须大于零。"),
        Message::CompensationIdle { code } => {
            Sentence::new(format!("刀尖半径补偿已打开，但对这里的 {code} 不起作用。"))
                .help("车螺纹时不进行补偿；G90、G94 要在刀补中输入刀尖半径才有效。")
        }
    }
}

/// What is wrong with a macro.
fn macro_fault(kind: FaultKind) -> Sentence {
    match kind {
        FaultKind::Overflow => Sentence::new("数值太大，超出宏程序的范围。"),
        FaultKind::DivisionByZero => Sentence::new("除数为零。").help("空变量按 0 计算。"),
        FaultKind::UnknownFunction => Sentence::new("没有这个函数。").help(
            "可用 SIN COS TAN ASIN ACOS ATAN SQRT ABS ROUND FIX FUP LN EXP POW MOD，自变量写在 `[ ]` 内。",
        ),
        FaultKind::Expression => Sentence::new("无法读取该表达式。")
            .help("写法如 `#1+2`、`[#1-#2]*3`、`SIN[#4]`：用方括号，两个值之间要有运算符。"),
        FaultKind::BracketOpen => Sentence::new("该 `[` 没有对应的 `]`。"),
        FaultKind::NumberOrCondition => Sentence::new("应为数值处写了条件，或应为条件处写了数值。")
            .help("条件用于比较：`[#1 GT 10]`，可用 EQ NE GT GE LT LE。"),
        FaultKind::VariableNumber => Sentence::new("没有这个变量。")
            .help("局部变量 #1～#33，公共变量 #100～#199、#500～#999，系统变量从 #1000 起。"),
        FaultKind::ReadOnly => Sentence::new("该变量只能读，不能写。"),
        FaultKind::BracketsTooDeep => Sentence::new("方括号嵌套超过五层。"),
        FaultKind::FunctionArgument => Sentence::new("函数对该值无解。").help("例如负数的平方根或对数。"),
        FaultKind::CallsTooDeep => Sentence::new("宏调用嵌套层数太多。"),
        FaultKind::EndMissing => Sentence::new("该 DO 没有同号的 END。"),
        FaultKind::Format => Sentence::new("无法读取该宏语句。").help(
            "写法如 `#1=#2+1`、`IF[#1 GT 5]GOTO 10`、`IF[#1 EQ 0]THEN #2=1`、`WHILE[#1 LE 9]DO1` … `END1`。",
        ),
        FaultKind::LoopNumber => Sentence::new("循环号为 1、2 或 3，且 END 要与正在执行的 DO 对应。"),
        FaultKind::WordsBehind => Sentence::new("宏语句必须单独一段。").help("把 NC 指令写在另一段。"),
        FaultKind::JumpTarget => Sentence::new("GOTO 需要 1～99999 的顺序号。"),
        FaultKind::ArgumentLetter => {
            Sentence::new("该地址不能作为宏的自变量。").help("不能使用 G、L、N、O、P。")
        }
    }
}

pub(super) fn fix_title(message: &Message) -> String {
    match message {
        Message::CommentOpen => "补上右括号".into(),
        Message::CommaForPoint { .. } => "改成小数点".into(),
        Message::LetterForDigit { digit, .. } => format!("改成数字 {digit}"),
        Message::ZeroForO { .. } => "改成字母 O".into(),
        Message::PrintedMinus => "改成负号".into(),
        other => sentence(other).message,
    }
}

pub(super) fn motion(motion: &Motion, passes: Option<u32>) -> String {
    let kind = match motion.kind {
        MotionKind::Rapid => "快速移动至",
        MotionKind::Feed => "切削进给至",
        MotionKind::ArcClockwise => "圆弧 G02 至",
        MotionKind::ArcCounterclockwise => "圆弧 G03 至",
        MotionKind::Thread => "螺纹切削至",
        MotionKind::Dwell => "暂停于",
    };
    let to = end_of(motion);
    if let Some(seconds) = motion.seconds {
        return format!("在 {to} 暂停 {} 秒", number(seconds));
    }
    let Some(cycle) = motion.cycle else {
        return format!("{kind} {to}");
    };
    let step = match cycle.step {
        Step::Infeed => "进刀",
        Step::Cut => "切削",
        Step::PullOut => "退尾",
        Step::Retract => "退刀",
        Step::Return => "返回",
        Step::Approach => "趋近",
        Step::Escape => "45° 退刀",
        Step::Contour => "沿轮廓",
        Step::Relief => "让刀",
        Step::Stepover => "移到下一列",
    };
    let manner = match motion.kind {
        MotionKind::Rapid => "快速",
        MotionKind::Thread => "随主轴同步",
        _ => "以进给",
    };
    let pass = match passes {
        Some(all) if cycle.pass > 0 => format!(" 第 {} 刀（共 {all} 刀）", cycle.pass),
        None if cycle.pass > 0 => format!(" 第 {} 刀", cycle.pass),
        _ => String::new(),
    };
    format!("{}{pass}：{manner}{step}至 {to}", cycle.cycle.code())
}
