//! The messages in Chinese.

use super::phrases::Phrase;
use super::wording::Wording;

/// The message, and on a second line its help.
#[rustfmt::skip] // One line each.
pub(super) const fn sentence(wording: Wording) -> &'static str {
    use Wording::*;
    match wording {
        NumberMissing => "地址 `{address}` 后面没有数值。\n\
            每个地址后面都要有数值。注释要写在括号里：`( … )`。",
        AddressMissing => "数值 `{number}` 前面缺少地址。\n\
            请在前面补上对应的地址，如 X、Z 或 F。",
        NotUnderstood => "`{text}` 不属于任何指令字。\n\
            是不是抄错或漏掉了字符？注释要写在括号里：`( … )`。",
        PlainText => "`{text}` 是普通文字，不是程序段。\n\
            系统读到这里会报警。说明文字要写在括号里：`( … )`。",
        SecondPoint => "`{word}` 中有两个小数点。\n\
            请核对数值，删去多余的小数点。",
        TooManyDigits => "`{word}` 的数值超过 8 位。\n\
            系统最多接受 8 位数字，小数部分也计算在内。",
        BlankInNumber => "`{written}` 的数值中间有空格，系统会读成 `{joined}`。\n\
            请删去空格；如果是漏了地址，请补上。",
        LetterForDigit => "`{word}` 中该写数字 {digit} 的地方写成了字母。\n\
            字母 O 与数字 0、字母 l 与数字 1 看上去很像，但系统会区分。",
        ZeroForO => "`{number}` 已按程序号读取：第一个字符应为字母 O。\n\
            程序号以字母 O 开头，不是数字 0。",
        PrintedMinus => "这是印刷用的横线，不是负号；这里已按负号读取。\n\
            系统不认识这个字符，请改成 `-`。",
        FullWidth => "`{word}` 用了全角字符，这里按 `{plain}` 读取。\n\
            数控系统不认识全角字符。请把输入法切换到半角，或改成半角字符。",
        CommaForPoint => "`{word}` 中该写小数点的地方写成了逗号。\n\
            G 代码的小数点是 `.`，不能用逗号代替。",
        CommentOpen => "括号没有闭合，本行余下的内容都当作注释。\n\
            请用 `)` 结束注释，否则系统可能把后面的程序段也当成注释。",
        CommentNested => "注释里又出现了括号。\n\
            系统读到第一个 `)` 就认为注释结束，后面的内容会当成指令字。",
        TextAfterSemicolon => "`;` 后面的 `{text}` 已当作注释。\n\
            在 FANUC 和 GSK 系统上，`;` 表示程序段结束；注释要写在括号里：`( … )`。",
        BlockTooLong => "这个程序段的指令字超过 {most} 个。\n\
            是不是漏了换行？程序段余下的内容没有读取。",
        TextTooLong => "程序有 {bytes} 字节，这里最多读取 {most} 字节。\n\
            请把程序拆开，或只打开要看的部分。",
        EmptyProgram => "还没有程序。\n\
            请输入或粘贴程序，也可以从示例库中选一个。",
        ProgramNumberZero => "O0 不能用作程序号。\n\
            程序号的范围是 O1～O9999。",
        DuplicateProgram => "程序号 O{number} 在这里重复出现。\n\
            同一个程序号，系统只能存一个程序。请给其中一个换一个未用的号，或删除它。",
        NoEnd => "程序结尾没有 M30 或 M02。\n\
            请在结尾写上 M30：否则系统报警停止时，主轴还在转，冷却液也没有关。",
        MoreMessages => "还有 {hidden} 条提示没有显示。\n\
            请先改正前面的错误，后面的往往由它们引起。",
        TooManyMotions => "程序的刀具运动超过 {most} 段，其余没有显示。\n\
            是不是循环中的某个量写得太小了？",
        TooMuchWork => "各循环的计算超过 {most} 步，后面的内容没有显示。\n\
            G70～G73 每调用一次都要重新读取精加工路线。请减少对长路线的调用，并改正不能执行的循环。",
        Stopped => "运行 {seconds} 秒后被中止，后面的内容没有显示。",
        CallNoNumber => "{code} 没有指明调用哪个程序。\n\
            P 为程序号：M98 P1000 调用 O1000，M98 P1000 L3 调用三次。",
        ProgramNotFound => "文本中没有 `{word}` 所指的程序，该调用被跳过。\n\
            子程序写在主程序之后：O 加程序号、程序段、M99。没有 L 时，最后四位之前的数字为重复次数：P51002 即 O1002 调用五次。",
        SequenceNotFound => "本程序中没有顺序号 N{sequence}，该跳转被跳过。\n\
            只在所在的 O 程序内检索。",
        CallTooDeep => "调用嵌套超过 {most} 层，运行在此结束。\n\
            程序调用自身，或两个程序互相调用，永远不会结束。",
        NoReturn => "该子程序结尾没有 M99。\n\
            系统在此报警停止；图形从调用处之后继续。",
        EndlessMain => "作为主程序运行时，本程序在 M99 处从头再来，无限循环；图中只画一遍。\n\
            自动送料加工常这样写。作为子程序由 M98 调用时，则返回调用它的程序。结束程序请写 M30。",
        TooManyRepeats => "从这里起，跳转、循环和调用执行的程序段超过 {most} 段，运行结束。\n\
            循环没有终点，或次数太多。请检查循环条件、计数变量或调用的 L。",
        TooMuchRepeated => "从这里起，跳转、循环和调用执行的程序段超过 {most} 个字符，运行结束。\n\
            循环没有终点，或很长的程序段重复次数太多。请检查循环条件、计数变量或调用的 L。",
        TooManyRounds => "循环和调用的次数超过 {most} 次，运行在此结束。\n\
            请检查该循环靠什么结束：条件、计数变量或调用的 L。",
        TooManyMacroSteps => "跳转、循环和调用中计算的宏语句和表达式超过 {most} 个，运行在此结束。\n\
            请检查循环靠什么结束，或减少每次循环中的计算。",
        NotRun => "O{number} 没有运行：没有程序调用它。\n\
            文本中有多个程序时运行第一个。可选择另一个程序查看。",
        NumberFromVariable => "`{word}`：N 和 O 的号码不能用变量给出。\n\
            请直接写出号码。GOTO、P、Q 可以用变量指定。",
        MacroOverflow => "数值太大，超出宏程序的范围。",
        MacroDivisionByZero => "除数为零。\n\
            空变量按 0 计算：是否应为另一个变量，或忘了赋值？",
        MacroUnknownFunction => "没有这个函数。\n\
            可用 SIN COS TAN ASIN ACOS ATAN SQRT ABS ROUND FIX FUP LN EXP POW MOD，自变量写在 `[ ]` 内。",
        MacroExpression => "无法读取该表达式。\n\
            写法如 `#1+2`、`[#1-#2]*3`、`SIN[#4]`：用方括号，两个值之间要有运算符。比较用 EQ NE GT GE LT LE，不用 `=`、`>`。",
        MacroBracketOpen => "该 `[` 没有对应的 `]`。\n\
            请在该部分结束处写 `]`：`[#1-#2]/2` 与 `[#1-#2/2]` 不同。",
        MacroNumberOrCondition => "应为数值处写了条件，或应为条件处写了数值。\n\
            条件用于比较：`[#1 GT 10]`，可用 EQ NE GT GE LT LE。",
        MacroVariableNumber => "没有这个变量。\n\
            局部变量 #1～#33，公共变量 #100～#199、#500～#999，系统变量从 #1000 起。",
        MacroReadOnly => "该变量只能读，不能写。\n\
            #0 永远为空，有些系统变量属于机床。请存入 #1～#33 或 #100～#199。",
        MacroBracketsTooDeep => "方括号嵌套超过五层。\n\
            请去掉不起作用的一对方括号，或先把一部分存入变量。",
        MacroFunctionArgument => "函数对该值没有定义。\n\
            例如负数的平方根或对数。",
        MacroEndMissing => "该 DO 没有同号的 END。\n\
            请在要重复的最后一段之后写同号的 END。",
        MacroFormat => "无法读取该宏语句。\n\
            写法如 `#1=#2+1`、`IF[#1 GT 5]GOTO 10`、`IF[#1 EQ 0]THEN #2=1`、`WHILE[#1 LE 9]DO1` … `END1`。",
        MacroLoopNumber => "循环号为 1、2 或 3，且 END 要与正在执行的 DO 对应。",
        MacroWordsBehind => "宏语句必须单独一段。\n\
            把 NC 指令写在另一段。",
        MacroJumpTarget => "GOTO 需要 1～99999999 的顺序号，不写字母 N：`GOTO 10`。",
        MacroArgumentLetter => "该地址不能作为宏的自变量。\n\
            不能使用 G、L、N、O、P。",
        MacroAlarm => "程序自身发出报警 {number}：{words}\n\
            #3000 由程序发出报警，多用于检查数据：请查看它之前的条件和调用时的自变量。",
        SystemVariable => "#{variable} 是这里未知的机床系统变量，读作空值。\n\
            与它有关的图形可能不正确。",
        ArgumentsUnknown => "这是宏程序本体：这里不知道 #{variable} 中的自变量。\n\
            与自变量有关的内容不确定，也不检查。请加上调用它的主程序，如 `G65 P100 A1`。",
        ForeignMill => "这像是铣床程序。\n\
            本页面读取 FANUC 和 GSK 车床程序，没有运行。若要照样运行，请在设置中把 `recognise` 设为 false。",
        ForeignPrinter => "这像是 3D 打印机程序。\n\
            本页面读取 FANUC 和 GSK 车床程序，没有运行。若要照样运行，请在设置中把 `recognise` 设为 false。",
        ForeignControl => "这像是 {origin} 的程序，这里不支持。\n\
            同样的代码在那里含义不同，因此没有运行。本页面读取 FANUC 和 GSK 车床程序。若要照样运行，请在设置中把 `recognise` 设为 false。",
        SystemGuessed => "按 G 代码体系 {system} 读取：该指令不属于体系 A。\n\
            体系 B 和 C 中，G90、G91 为绝对和增量，G92 设定坐标系或最高转速，G77 G78 G79（B）为循环。可在设置中指定体系。",
        LeastMillimetres => "无小数点 = 0.001 mm：`{word}` 是 {value} mm。\n\
            看来该程序用于无小数点的数按最小输入增量计数的系统（FANUC 参数 3401#0 为 0）。可在设置中选定 `decimal`。",
        LeastInches => "无小数点 = 0.0001 in：`{word}` 是 {value} in。\n\
            看来该程序用于无小数点的数按最小输入增量计数的系统（FANUC 参数 3401#0 为 0）。可在设置中选定 `decimal`。",
        LeastSeconds => "无小数点 = 0.001 s：`{word}` 是 {value} s。\n\
            看来该程序用于无小数点的数按最小输入增量计数的系统（FANUC 参数 3401#0 为 0）。可在设置中选定 `decimal`。",
        TooLargeMillimetres => "`{word}` 在这里等于 {value} mm，大得不合理。\n\
            本次运行中，无小数点的数按整单位计；而该程序似乎以它们表示最小输入增量（0.001 mm、0.0001 in、0.001 s）。请在设置中选定 `decimal`，或写上小数点。",
        TooLargeInches => "`{word}` 在这里等于 {value} in，大得不合理。\n\
            本次运行中，无小数点的数按整单位计；而该程序似乎以它们表示最小输入增量（0.001 mm、0.0001 in、0.001 s）。请在设置中选定 `decimal`，或写上小数点。",
        TooLargeSeconds => "`{word}` 在这里等于 {value} s，长得不合理。\n\
            本次运行中，无小数点的数按整单位计；而该程序似乎以它们表示最小输入增量（0.001 mm、0.0001 in、0.001 s）。请在设置中选定 `decimal`，或写上小数点。",
        ReferenceNumber => "`{word}` 不是 G30 的参考点号。\n\
            P2、P3、P4 是第二到第四参考点；第一参考点用 G28，不写 P。",
        NotAtReference => "G27 的终点不是参考点，这里参考点为 X{x} Z{z}。\n\
            G27 检查刀具是否到达参考点，未到达则报警。",
        NoIntermediate => "G29 没有中间点：之前没有 G28 或 G30。\n\
            G29 经同一中间点从 G28 返回。请在它之前写 G28，或用 G00 直接走到。",
        MachineZero => "G53 以机床零点计算；这里取参考点 X{x} Z{z} 为机床零点。\n\
            程序无需修改。要画出正确位置，请在设置的 `refPoint` 中填写回零后的位置。",
        OffsetNumber => "`{word}` 不是偏置表中的号码。",
        TipNumber => "`{word}` 不是刀尖方位号：应为 0 到 9。",
        DataPassedOver => "从这里到 G11 是写入系统数据表的数据，被跳过。\n\
            如确实如此则无需修改；若 G11 写得太晚，请把它提前。",
        HoleInForce => "{hole} 有效时不能写 `{word}`。\n\
            先写 G80：在此之前每个 X、Z 或 C 都会再加工一个孔。",
        PeckZero => "`{word}` 不是有效的每次切深。\n\
            Q 是每次啄钻的深度，单位微米，例如 Q5000。不写 Q 则一次钻到底。",
        HoleNoDepth => "{code} 没有孔深。\n\
            G83 G84 G85 用 Z 或 W，G87 G88 G89 用 X 或 U 给出孔底。",
        HoleOfOthers => "FANUC 体系 A 没有 {code}；按有此代码的车床画出。\n\
            从起点沿 Z 钻孔并退回。FANUC 车床系统用 G83 或 G74 钻孔。",
        UnknownG => "`{word}` 不是本系统的 G 代码。\n\
            整个程序段都不执行，请核对代码。",
        UnknownM => "`{word}` 只在部分机床上有效，这里跳过不执行。\n\
            它的功能请查机床厂家的说明书。",
        NotSupported => "这里不支持 {what}。\n\
            这不是程序的错。此后的刀具轨迹可能不准确，用淡色画出。",
        MakerG => "`{word}` 因机床而异，被跳过。\n\
            机床说明书中有此代码则保留；否则是笔误，请改正或删除。其动作没有画出。",
        PointNotAllowed => "`{word}` 必须是整数，不能带小数点。",
        MinusNotAllowed => "`{word}` 不能是负值。",
        DuplicateWord => "地址 {address} 在本程序段中出现了两次，以 `{used}` 为准。\n\
            系统会取后一个，或者报警。请删去写错的那个。",
        SameGroup => "`{dropped}` 与 `{used}` 不能同时有效，以 `{used}` 为准。\n\
            两者属于同一个模态组，同一程序段中最后一个有效。",
        AbsoluteAndIncremental => "`{absolute}` 与 `{incremental}` 指定的是同一个轴，以 `{used}` 为准。\n\
            各系统的处理不同：FANUC 取后写的，GSK 取绝对坐标。",
        ToolWithSetting => "`{word}` 不能与 G50、G10 或 G04 写在同一程序段。\n\
            请把换刀单独写成一个程序段。",
        ToolWithHighestSpeed => "`{word}` 与 G50 S 写在同一程序段：有些系统会以 PS0245 报警停止。\n\
            许多旧系统可以接受。为稳妥起见，换刀请单独写一个程序段。",
        ShortTool => "`{word}` 没有写刀号：只调用 {offset} 号刀补，刀架不转位。\n\
            在四位数 T 代码的系统上要写全刀号和刀补号，如 T0101。",
        ToolNumber => "`{word}` 不是有效的 T 代码。\n\
            请写刀号和刀补号，如 T0101。",
        ToolNumberOfMachine => "`{word}` 是否为有效的 T 代码取决于机床。\n\
            带刀库或刀补很多的机床使用这样的数字；刀架式机床写刀号和刀补号，如 T0101。",
        G90AsAbsolute => "车床上的 G90 是外圆切削循环，不是绝对值编程。\n\
            车床上 X、Z 总是绝对坐标，U、W 总是增量坐标。这里的 X 或 Z 没有自己的 G 代码，会启动循环：请删去 G90，或在其前写 G00 或 G01。",
        LetterIIsTaper => "G92 中的 I 已按锥度（同 R）读取。\n\
            FANUC 把 I 当作锥度（R 的旧写法），GSK 把 I 当作每英寸牙数。",
        G28NoAxis => "{code} 没有指定轴：FANUC 系统上刀具不动，有的系统各轴都返回。图中不画移动。\n\
            在 {code} 后写 U0 W0，各种系统上两轴都返回该点。只提示一次。",
        DwellWithPoint => "`{word}` 带小数点，按秒读取。\n\
            FANUC 的 P 为毫秒，不带小数点，否则报警；Haas 读作秒。用 X 或 U 在各种系统上都是秒。",
        DwellNoTime => "G04 没有写时间，不会暂停。\n\
            请用 X 或 U 指定秒数，或用 P 指定毫秒数，都要大于零：`G04 X0.5` 或 `G04 P500` 是半秒。F 不是时间。",
        AxisNotHere => "这里不支持 `{word}` 的 Y 轴：只画 X、Z 和 C。\n\
            X 和 Z 的运动照常画出，此后以淡色表示。只提示一次。",
        PlaneNotHere => "这里不支持 G12.1 以外 {word} 平面的圆弧。\n\
            车削用 G18；端面铣圆弧写在 G12.1 之内。只提示一次。",
        CAxisNotConnected => "这里 C 轴运动，但之前没有连接 C 轴。\n\
            所用代码因机床而异，例如 M45 和 G28 H0。主轴方式下使用 C 会报警。",
        LiveToolStopped => "这里用动力刀具切削，但之前没有启动动力刀具。\n\
            所用代码因机床而异，例如 M13 或 M14 加 S。",
        PolarForbidden => "G12.1 与 G13.1 之间不允许使用 `{word}`。\n\
            其间只能使用 G01 G02 G03 G04 G40 G41 G42 G65 G66 G67 G98 G99：用 G01 接近，或先用 G13.1 取消。",
        PolarFrame => "`{word}` 在 G12.1 与 G13.1 之间改变了坐标系。\n\
            请在 G12.1 之前设定零点：X0 必须是主轴中心。",
        PolarNotAlone => "{code} 必须单独一段，不能与 `{other}` 同段。\n\
            把其他指令移到另一段。",
        PlaneCompensation => "{code} 处于 G41 或 G42 方式中。\n\
            补偿要在方式内部建立和取消：在 G12.1 或 G07.1 C… 之后建立，在 G13.1 或 G07.1 C0 之前用 G40 取消。",
        PolarFeedPerTurn => "极坐标插补中不能用每转进给（G99）。\n\
            此时主轴只作定位：请写 G98，F 单位为 mm/min。",
        PolarNoRadius => "这里 G41 或 G42 没有刀具半径，不起补偿作用。\n\
            在刀具的偏置中填入半径，刀具中心即与轨迹保持该距离。",
        PolarRadiusUnknown => "{offset} 号刀补的刀具半径未知，图形按未补偿的轨迹绘制。\n\
            半径可能在机床的偏置表中。要看补偿后的轨迹，请写入设置。",
        PolarAngle => "`{word}` 像是角度；在 G12.1 与 G13.1 之间 C 是长度，单位 mm。\n\
            轨迹写在平面内：X 向右，为直径值；C 向上，单位 mm。",
        PolarCenter => "轨迹距主轴中心仅 {distance} {mm}，C 轴转速将趋于无限大。\n\
            系统会在此减速或报警。请远离中心。",
        PlaneLeftOn => "到 `{code}` 时带 C 轴的插补仍然有效。\n\
            之前请单独一段写 {off}。",
        CylinderFormat => "G07.1 需要用 C 给出圆柱半径，且不能有其他指令。\n\
            G07.1 C30 以半径 30 mm 开始，G07.1 C0 结束；不能重复开始。",
        CylinderForbidden => "圆柱插补中不允许使用 `{word}`。\n\
            其间只能使用 G01 至 G04 和 G40 至 G42，圆弧用 R 给出，快速移动写在 G07.1 之前或 G07.1 C0 之后。",
        FeedMissing => "没有进给速度：切削之前没有给出不为零的 F。\n\
            刚开机时系统在此报警；否则按前一个程序的 F 切削。请加上 F，如 G99 时写 F0.2（mm/r），G98 时写 F200（mm/min）。",
        LeadMissing => "{code} 没有给出导程。\n\
            F 指定螺纹导程，单位 mm；单线螺纹的导程就是螺距。",
        FeedPerTurnTooLarge => "G99 状态下，`{word}` 是主轴每转进给 {feed} {mm}。\n\
            这样的进给量太大，无法切削。是不是要用 G98（mm/min）？请改系统的进给方式，或在程序中写 G98。",
        FeedPerMinuteTooSmall => "G98 状态下，`{word}` 只是每分钟进给 {feed} {mm}。\n\
            是不是要用 G99（mm/r）？请改系统的进给方式，或在程序中写 G99。",
        FeedNotRepeatedPerTurn => "改用 G99 后，原来的进给 {feed} 按 {mm}/r 计算。\n\
            改变进给方式后，要重新写 F。",
        FeedNotRepeatedPerMinute => "改用 G98 后，原来的进给 {feed} 按 {mm}/min 计算。\n\
            改变进给方式后，要重新写 F。",
        SpindleStopped => "主轴没有转，刀具就在切削。\n\
            切削之前，请先用 M03 或 M04 启动主轴，转速 S 要大于零。",
        NoSpeedClamp => "用了 G96 恒线速，却没有限制主轴最高转速。\n\
            越靠近中心，转速升得越高，没有上限。请先限速，如 G50 S2000。",
        ClampReversed => "主轴最低转速 Q{lowest} 高于最高转速 S{highest}。",
        ThreadAtSurfaceSpeed => "{code} 在 G96 恒线速状态下车螺纹，主轴转速会随 X 变化。\n\
            每一刀都要切在同一条螺旋槽里，否则会乱牙：请用 G97 S… 指定固定转速。",
        ArcNoCenter => "{code} 既没有 R，也没有 I、K。\n\
            请用 R 给出半径，或用 I、K 给出圆心相对于圆弧起点的坐标；或者本想写 G01？FANUC 在参数未设报警时走直线。",
        ArcRadiusTooSmall => "`{word}` 太小：圆弧起点与终点相距 {distance} {mm}。\n\
            半径至少要 {least} {mm}，即距离的一半。注意 X 是直径值。",
        ArcEndOffCircle => "终点不在圆上：圆心到起点是 {start_radius} {mm}，到终点却是 {end_radius} {mm}。\n\
            I 是圆心相对于起点的 X 向增量（半径值），K 是 Z 向增量，都带正负号。",
        ArcNoRadius => "I 和 K 都是零：圆心就是起点，圆弧没有半径。\n\
            I 是圆心相对于起点的 X 向增量（半径值），K 是 Z 向增量；也可用 R 指定半径。",
        ArcRadiusNegative => "本系统不接受 `{word}`。\n\
            小于 180° 的圆弧请去掉 R 的负号；大于 180° 的圆弧请用 I、K 编程。",
        ArcNowhere => "圆弧的终点就是起点，用 R 编程时刀具不动。\n\
            整圆要用 I、K 编程。",
        TaperBeyondHalf => "`{word}` 超过 `{axis}{limit}` 的一半：切削起点会落到循环起点之外。\n\
            R 与 {axis} 的符号不一致时，要求 |R| ≤ |U/2|。",
        TaperBeyondLength => "`{word}` 超过 `{axis}{limit}` 的长度：切削起点会落到循环起点之外。\n\
            R 与 {axis} 的符号不一致时，要求 |R| ≤ |W|。",
        TaperNotExtended => "从这个起点起，R{taper} 的锥面与毛坯边缘交于 {axis}{crossing}；要交于 {axis}{wanted}，应为 R{needed}。\n\
            R 从循环起点算起，而起点在毛坯之外。R{taper} 如果是图样上锥面的高度，要按比例加大；如果已按这个起点算出，就是对的。",
        ContourNotNamed => "{code} 必须同时写 P 和 Q。\n\
            P 是精加工路线第一个程序段的顺序号，Q 是最后一个程序段的顺序号。",
        ContourNotFound => "找不到 `{word}` 指定的程序段。\n\
            P 指定精加工路线的第一段，Q 指定最后一段；两段要在同一个程序中，Q 段在 P 段之后。",
        ContourReversed => "`{word}` 指定的程序段在 P 指定的 N{first} 之前。\n\
            P 指定精加工路线的第一段，Q 指定最后一段。P 和 Q 是不是写反了？",
        ContourFirstBlock => "{code} 精加工路线的第一段没有用 G00 或 G01 移动。\n\
            这一段要把刀具从循环起点移到轮廓的起点。",
        ContourIllegal => "`{word}` 不能写在 P 段到 Q 段之间。\n\
            精加工路线只能用 G00、G01、G02、G03 编程。这个循环不执行。",
        ContourReachesOver => "{code} 的 P、Q 之间包含了其他加工：第 {line} 行的 `{word}`。\n\
            请检查顺序号：可能重复，或 Q 指到了很后面的程序段。该循环不执行。",
        ContourCall => "`{word}` 在精加工路线中调用了子程序。\n\
            请把移动指令直接写在 P 段到 Q 段之间。这个循环不执行。",
        ContourBothAxes => "{code} 精加工路线的第一段也写了 {other}，但 {other} 向并不移动。\n\
            第一段写了两个轴，系统会按类型 II（凹槽）处理。要用类型 I，请删去这个指令字。",
        ContourTypeTwo => "{code} 精加工路线的第一段两轴同时移动，本系统不接受。\n\
            没有类型 II（凹槽）功能时，这一段只能移动一个轴。",
        ContourTurnsBack => "{code} 的精加工路线在第 {line} 行沿 {axis} 向折返或切得更深。\n\
            类型 I 要求轮廓在 X、Z 两个方向上都单调变化；类型 II（第一段写两个轴）允许切深方向有凹槽。",
        ContourBeyondStart => "{code} 的精加工路线在 {axis} 向超出了循环起点。\n\
            循环起点要选在轮廓之外。",
        ContourNothingToCut => "循环起点与该轮廓之间没有可供 {code} 切削的余量。\n\
            首段应走到比循环起点更深的直径（G72 为长度），其后还应有多段移动。",
        ContourOpenEnd => "`{word}` 写在精加工路线的最后一段，后面没有移动。\n\
            精加工路线不能以倒角、倒圆或终点未定的角度结束。",
        DepthMissing => "{code} 没有给出背吃刀量。\n\
            请在第一个程序段中指定，如 G71 U2 R0.5 或 G72 W2 R0.5。与 P、Q 写在一起的 U、W 是精加工余量。",
        DepthNotPositive => "{code} 的背吃刀量 {depth} 必须大于零。\n\
            背吃刀量不带正负号，进刀方向由精加工路线决定。小于 0.001 mm 的位数会被舍去。",
        AllowanceSign => "精加工余量 `{word}` 的方向指向零件内部。\n\
            车外圆时 U 为正，车内孔时 U 为负；W 的方向与切削方向相反。",
        PatternNoPasses => "G73 没有给出循环次数。\n\
            第一段的 R 是刀数，U（半径值）和 W 是要切除的余量，如 G73 U9 W2 R5。",
        PatternPasses => "G73 的循环次数不能是 {passes}。",
        TooManyPasses => "{code} 的刀具运动会超过 {most} 段，循环不执行。\n\
            是不是背吃刀量、每次进刀量或第一刀切深写得太小了？不带小数点的数值可能按 μm 计算。",
        PeckNegative => "`{word}` 不能是负值。\n\
            每次进刀量和移动量不带正负号，方向由终点坐标决定。",
        PeckMissing => "{code} 在这个轴上有移动，却没有写 {address}。\n\
            P 是 X 向每次的移动量（半径值），Q 是 Z 向每次的移动量，单位 μm：P3000 即 3 mm。",
        ReliefNegative => "这里的退刀量 `{word}` 不能是负值。\n\
            退刀方向由每次移动的方向决定。",
        AmountInMillimetres => "`{word}` 已按 mm（G20 时按英寸）读取。\n\
            FANUC 和 GSK 系统的 P、Q 以 μm 为单位，不带小数点：5 mm 写成 5000。单位可用 pqUnit 设定。",
        ThreadAngle => "G76 的刀尖角度不能是 {angle}°。\n\
            FANUC 只接受 80、60、55、30、29 和 0 度，写在 P 的最后两位。",
        ThreadLeastDepth => "最小切深 {least} {mm} 大于牙型高度 {height} {mm}。\n\
            第一段的 Q 是每刀最小切深，单位 μm，通常 20～100；第二段的 P 是牙型高度。",
        ThreadNoHeight => "G76 的牙型高度 P 必须大于零。\n\
            P 是牙型高度，约为螺距的 0.65 倍（螺距 2 mm 时 P1300），Q 是第一刀切深，都是半径值，单位 μm。",
        ThreadNoFirstDepth => "G76 的第一刀切深 Q 必须大于零。\n\
            P 是牙型高度，Q 是第一刀切深，都是半径值，以 μm 为单位。",
        ThreadStartInside => "G76 的循环起点 X{start} 没有让开螺纹牙顶 X{crest}。\n\
            每一刀之后刀具都要退回循环起点的 X 坐标，那里不能碰到工件。",
        ThreadStartAtCrest => "G76 的循环起点 X{start} 正好在按 P 算出的牙顶上。\n\
            每一刀之后刀具都退回循环起点的 X 坐标；只有外圆事先车得更小，刀具才不碰工件。",
        CornerNoMove => "`{word}` 后面没有直线移动，无法形成拐角。\n\
            下一个程序段要用 G01 移动（GSK 的 `L`、`D` 后面也可以是 G02、G03）。",
        CornerTooLarge => "`{word}` 太大，超过了相邻两段移动的长度。\n\
            它要从相邻每段中切去这么长；X 是直径值，X46 到 X50 只有 2 mm。请减小倒角或圆角，或加长移动。",
        CornerNone => "`{word}`：这两段移动之间没有拐角。\n\
            路径在此原路折返。请把它写到有拐角的段里，或删除。",
        CornerStraight => "`{word}`：下一段移动继续直行，系统不插入任何移动。\n\
            两段夹角小于 1° 时，系统认为没有拐角。请把它写到有拐角的段里，或删除。",
        CornerNoLine => "`{word}`：这个程序段没有拐角。\n\
            倒角和倒圆角要写在 G01 的移动中（`,C`、`,R` 也可用于 G02、G03）；快速移动和循环没有拐角。",
        CornerAxis => "`{word}` 与下一段移动不符。\n\
            不带逗号的倒角、倒圆，前后两段要分别沿不同的轴移动；正负号表示下一段的移动方向。",
        CornerTwice => "`{word}` 和 `{other}` 都是倒角指令，一个程序段只能有一个。",
        CornerInThread => "`{word}`：螺纹切削程序段中不能倒角或倒圆。\n\
            请把倒角写在 G01 程序段中。",
        CornerWithCompensation => "`{word}` 写在刀尖半径补偿建立或取消的程序段中。\n\
            请把 G40、G41、G42 写在没有倒角的程序段中。",
        CyclePlane => "{code} 只能在 G18 平面内使用。\n\
            请先写 G18。",
        CycleWord => "`{word}` 不能写在 {code} 程序段中。\n\
            轮廓由 P 到 Q 的程序段给出；循环程序段只写 P、Q、U、W 和 F、S、T。",
        CycleAxis => "`{word}`：{code} 只能使用 X、Z 轴。\n\
            请在循环之前用单独的程序段移动该轴。",
        FinishStart => "G70 的起点与粗车循环的起点 X{roughed_x} Z{roughed_z} 不同。\n\
            第一段和最后一段是快速移动，从别的点出发可能碰到工件。",
        FinishWithoutRoughing => "G70 精车 N{first} 到 N{last} 的轮廓，但没有 G71、G72 或 G73 粗车它。\n\
            毛坯是否已接近成品尺寸？或者 P、Q 写错了顺序号？",
        AngleNoPoint => "由 `{word}` 求不出终点。\n\
            角度从 +Z 方向起按逆时针计算。两条直线必须相交；只有一条直线时，除角度外还要写 X 或 Z。",
        CompensationOnArc => "{code} 不能在圆弧上建立或取消补偿。\n\
            G40、G41、G42 要写在直线移动的程序段中（G00 或 G01）。",
        CompensationOvercut => "刀尖半径 R{radius} 在这里放不下，会产生过切。\n\
            台阶高度、槽宽或内圆弧半径太小，容不下刀尖圆弧。请换刀尖半径更小的刀片，或把该处加大到不小于刀尖半径。",
        CompensationNoIntersection => "刀尖半径为 R{radius} 时，这两段移动补偿后没有交点。\n\
            请检查这两段的终点和半径：偏移刀尖半径后它们仍须相交。",
        CompensationPlane => "G41 或 G42 有效时，不能切换平面。\n\
            请先在换平面之前的移动段中写 G40 取消补偿。",
        LeadRunsOut => "按 `{word}`，G34 的导程在 {reached} {mm} 后减小到零，而螺纹长 {length} {mm}。\n\
            K 是主轴每转的导程增减量，直到终点导程都必须大于零。",
        CompensationIdle => "刀尖半径补偿已打开，但这里的 {code} 不进行补偿。\n\
            车螺纹、切槽时不补偿，多数系统粗车时也不补偿；G90、G94 要在刀补中输入刀尖半径才有效。",
        LeadingZero => "`{word}` 的值是 {value}：前面的零不起作用。\n\
            很可能漏了小数点，应为 `{meant}`。漏掉后数值大了十倍以上。",
        PointMissing => "`{word}` 没有小数点，而程序中其他数都写了小数点。\n\
            是否漏了小数点？按最小设定单位计数的系统会读成 {thousandths} {mm}。",
        FarOff => "`{word}` 走到 {axis}{to}，远远超出程序其余部分（其余部分离 {axis}0 不超过 {farthest} {mm}）。\n\
            是否漏了小数点，或多打了一位数字？",
        MinusMissing => "`{word}` 向远离卡盘的方向切削，在工件前方走空。\n\
            是否漏了负号？`{meant}` 才会切入工件；端面前方没有材料。",
        IncrementalForAbsolute => "`{word}` 是从刀具当前位置起算的增量，走到 {axis}{to}。\n\
            U、W 是增量，X、Z 是绝对坐标。程序其余部分都用绝对坐标：是否应为 `{meant}`？",
        SpeedMissing => "开始切削，但没有指定主轴转速 S。\n\
            第一次切削前请用 G97（r/min）或 G96（m/min，G20 时为 ft/min）给出 S，如 G97 S800 M03。",
        SurfaceSpeedMissing => "在 G96 状态下切削，但 G96 没有自己的 S。\n\
            前面的 S 是 G97 的转速（r/min）。请在 G96 后写切削速度，如 G96 S120。",
        SpeedNotRepeated => "{code} 未写 S：主轴保持刚才的 {speed} r/min。\n\
            G96 时 S 是线速度（m/min，G20 时为 ft/min），G97 时是转速（r/min）。请在 {code} 后重新写 S。",
        ThreadTooFast => "螺距 {pitch} {mm} 时 S{speed} 过快：约 {limit} r/min 以内拖板才跟得上。\n\
            经验公式 n ≤ 1200/P − 80。超过时螺纹两端螺距不准。",
        ThreadSpeedChanged => "同一螺纹的两刀之间主轴转速由 {before} 变为 {now}。\n\
            各刀将不在同一螺旋槽内（乱牙）。从第一刀到最后一刀请保持转速不变。",
        ThreadStartMoved => "本刀起点为 Z{now}，上一刀为 Z{before}：两刀不在同一螺旋槽。\n\
            差值必须是导程 {lead} {mm} 的整数倍，或用 Q 指定另一线的起始角。",
        ThreadRunIn => "升速进刀段 {have} {mm} 对此转速和导程偏短，约需 {need} {mm}。\n\
            拖板加速期间螺距不准。请把起点放远些，或降低转速。",
        ThreadHeight => "螺距 {pitch} {mm} 的 60° 螺纹，牙型高度 {height} {mm} 不合适，一般约 {usual} {mm}。\n\
            P 是单边牙型高度（半径值），单位 μm，约为螺距的 0.65 倍。是否写成了直径值或漏了一位？",
        ThreadFirstDepth => "第一刀切深 {first} {mm} 大于整个牙型高度 {height} {mm}。\n\
            P 是牙型高度，Q 是第一刀切深，都是半径值，单位 μm。是否写反了？",
        ThreadLeastLarge => "`{word}` 使最小切深为 {least} {mm}。\n\
            第一段的 Q 单位是 μm，通常 20～100。精加工次数、退尾量（螺纹倒角量）、刀尖角度由 P 的六位数字指定。",
        ThreadPullOut => "退尾量（螺纹倒角量）{pull_out} {mm} 大于退回起点直径的距离 {way} {mm}。\n\
            45° 退尾会越过起点。请把起点放远，或减小第一段 P 中的 r。",
        FeedOfThread => "{feed} {mm} 仍是前面螺纹的导程，现在成了本次切削的进给量。\n\
            螺纹之后车削请重新写 F：每转 {feed} {mm} 会崩刀。",
        LeadOfFeed => "{code} 段没有写 F：前面切削的进给 {feed} {mm} 成了螺纹导程。\n\
            请在 {code} 段写出导程，如 F1.5。",
        TaperNarrows => "`{word}` 使锥面朝卡盘方向变小。\n\
            外圆锥朝卡盘方向变大时 R 为负，内锥孔朝卡盘变小时 R 为正：R = 切削起点半径 − 终点半径。符号对吗？",
        TaperCrossesAxis => "`{word}` 使切削从 X{x} 开始，越过了主轴轴线。\n\
            R 是半径差：终点 X 加两倍 R 就是切削起点。请检查 R 的符号和小数点。",
        TaperEdge => "这一刀锥面在小端切深达 {depth} {mm}。\n\
            车锥面时切深沿长度变化。请从更大的直径开始逐刀接近。",
        PassNotDeeper => "`{word}` 没有比之前的 {axis}{deepest} 更深，这一刀是空走。\n\
            循环的每一刀都应更深。是否数字看错或行序颠倒？",
        AirCut => "循环起点在 {axis} 向距工件 {distance} {mm}，每一刀都要以切削进给空走这段距离。\n\
            起点距毛坯 1～3 mm 即可。",
        StartBehindFace => "循环起点 Z{z} 在毛坯端面 Z{face} 之后。\n\
            G90、G94 前面的材料没有切除；G92、G76 会快速扎入工件。起点应在端面之前。",
        StartInStock => "{code} 的起点 X{x} 在材料之内。\n\
            每一刀后刀具都快速返回起点直径，起点必须在材料之外。",
        ToolChangeNear => "在 X{x} Z{z} 换刀 {tool}，离工件太近。\n\
            刀架转动时其他刀具会扫过工件。请先退到换刀点，如 X200 Z200；镗刀要更远。",
        BoreRetract => "快速退出内孔时在 X{x} Z{z} 碰到孔壁。\n\
            先向小直径方向离开孔壁，再单独沿 Z 退出孔外，最后去换刀点。",
        GrooveStep => "`{word}` 即移动量 {step} {mm}，不小于刀宽 {width} {mm}，各刀之间会留下残料。\n\
            各刀必须重叠：Q 应小于刀宽。",
        EscapeTooLarge => "退刀量 `{word}` 大于背吃刀量 {depth} {mm}。\n\
            每刀后刀具沿 45° 退刀 R，通常 0.5 mm 左右。",
        ContourStartMoved => "轮廓从 {axis}{first} 开始，而 {code} 的起点是 {axis}{start}。\n\
            第一段只应移动另一轴：两点的 {axis} 应相同。",
        ContourNotClosed => "轮廓终点 X{x} 在毛坯 Ø{diameter} 之内，那里会留下台阶。\n\
            最后一段应走到起点直径，使刀具离开工件。",
        PatternShallow => "G73 第一刀切深达 {depth} {mm}：退刀总量 {relief} {mm} 小于要切除的余量。\n\
            第一段的 U 是总切除量（半径值）：（毛坯直径 − 最小直径）÷ 2。",
        PatternAir => "G73 第一刀有 {share} % 在毛坯之外空走。\n\
            G73 用于铸锻件毛坯。棒料用 G71 更快。",
        CompensationInCycle => "`{word}` 写在 {code} 程序段里：循环进行中不能切换补偿。\n\
            刀尖半径补偿应在单独的段里，在到起点的移动中建立，在最后一刀之后取消。",
        CompensationLeftOn => "到 `{word}` 时 {code} 仍未取消。\n\
            在 G40 之前轨迹一直偏移刀尖半径。请先在离开工件的移动中写 G40。",
        CompensationSide => "这里 {code} 使刀尖偏到材料一侧，应为 {right}。\n\
            朝卡盘方向车外圆用 G42，镗孔用 G41；反方向时相反。",
        CompensationTurnsBack => "{code} 有效时路径原路折返：刀尖会转到路径的另一侧。\n\
            它会切入刚车好的表面，最多为刀尖半径的两倍。请先使刀具离开轮廓，或用 G40 取消补偿。",
        CompensationIdleBlocks => "补偿有效期间连续两个程序段没有移动。\n\
            系统只预读几个程序段；读不到下一移动时会在拐角过切或欠切。请把这些段放到别处。",
        CompensationShort => "建立或取消补偿的移动 {length} {mm} 小于刀尖半径 {radius} {mm}。\n\
            该移动至少为半径，最好两倍，并在材料之外。",
        CompensationTip => "该刀的刀尖方位号为 {tip}，系统把刀尖圆弧中心当作刀尖。\n\
            外圆车刀一般为 3，镗刀为 2：在设置的 `tip` 或程序注释 TOOL 的 TIP= 中给出。",
        ChuckOpen => "`{word}` 在许多机床上是松开卡盘，而主轴仍在旋转。\n\
            请先用 M05 停主轴。",
        TapReverse => "丝锥退出时主轴没有反转。\n\
            攻入后在孔底 M05，再 M04（左旋用 M03），用相同 F 的 G32 退出。快速退出会拉坏螺纹。",
        TapSurface => "在轴线上攻丝需要恒转速：G97 S…。\n\
            G96 下 X0 处转速会升到上限。",
        DuplicateSequence => "N{sequence} 在第 {line} 行又出现一次；这里取本段之后的第一个。\n\
            P、Q、GOTO、M99 P 按顺序号查找。被查找的顺序号应唯一。",
        ArcOverHalf => "`{word}` 为负：圆弧走大于 180° 的一侧。\n\
            车削轮廓几乎不会这样。是否应为正 R？",
        NotCompared => "程序超过 {most} 段，或动作超过其十倍：不再相互比较各数值。\n\
            程序本身没有错，只是不会提示漏小数点、漏负号或把 X 写成 U。上限由设置中的 `limits.comparedBlocks` 决定。",
        CoolantOff => "切削时没有开冷却液。\n\
            第一次切削前用 M08 打开，结束时用 M09 关闭。",
        FeedModeNotNamed => "切削之前没有写 G98 或 G99。\n\
            这时 F 的单位取决于系统当前状态。请在程序开头写 G99（mm/r）或 G98（mm/min）。",
        ToolNotNamed => "这次切削没有刀具：之前没有 T 指令。\n\
            刀架上可能是任意一把刀。请调用刀具和刀补，如 T0101。",
        FeedOnlyForFinishing => "`{word}` 写在轮廓段内：只有 G70 使用它。\n\
            G71、G72、G73 粗车时用自身程序段或之前的 F、S、T。",
        StopBehindMove => "M05 与移动写在同一段：移动完成后主轴才停。\n\
            M05 单独写一段，放在移动之前或之后。",
        SetupPositive => "设置中的 `{key}` 为 {value}，必须大于零。\n\
            毛坯、刀具或尾座有一个值错误，就整个按未给出处理，图形照常显示。",
        SetupNotNegative => "设置中的 `{key}` 为 {value}，不能为负数。\n\
            毛坯、刀具或尾座有一个值错误，就整个按未给出处理，图形照常显示。",
        SetupBelow => "设置中的 `{key}` 为 {value}，必须小于 {most}。\n\
            内孔要小于外径，卡爪夹持长度要小于毛坯长度。毛坯或刀具有一个值错误，就整个按未给出处理。",
        SetupAtMost => "设置中的 `{key}` 为 {value}，最大为 {most}。\n\
            长度单位为毫米，角度单位为度。毛坯、刀具或尾座有一个值错误，就整个按未给出处理。",
        NoteWord => "设置注释中不能写 `{word}`。\n\
            这里可以写：{expected}",
        PartTooManyMotions => "程序的刀具运动超过 {most} 段：只显示轨迹，不计算零件，也不检查碰撞。\n\
            上限由设置中的 `limits.partMotions` 决定。",
        PartStopped => "零件计算在第 {done} 段（共 {all} 段）后停止：只显示轨迹，不显示零件。\n\
            修改程序或设置即可重新开始。",
        BehindLeftOut => "前面有程序段没有照原样执行：从这里起不再检查与工件的碰撞。\n\
            工件还剩下什么无法确定。请先改正那个程序段。",
        BehindLeftOutCuts => "前面有程序段没有照原样执行：与它有关的 {cuts} 段切削以淡色画出，不从零件上切除。\n\
            工件还剩下什么无法确定，从这里起不再检查与工件的碰撞。请先改正那个程序段。",
        PartTooManyCorners => "零件轮廓超过 {most} 个点：只显示轨迹，不显示零件，碰撞只检查到这里为止。\n\
            上限由设置中的 `limits.partCorners` 决定。",
        ElsewhereLeftOut => "从这里起在另一个工件坐标系中的切削（共 {cuts} 段）不从零件上切除：不知道它的零点在哪里。\n\
            可能是第二次装夹或副主轴。要看它们切出的形状，请把它们写成单独的程序。",
        ToolUnknown => "不知道 {tool} 是什么刀具：只显示轨迹，不显示零件。\n\
            常用的刀片和切槽刀在这里都会切坏轮廓。请在设置或注释中说明这把刀，例如 `(TOOL {tool} TYPE=GROOVING WIDTH=3)`。",
        ToolNotListed => "设置中列出了刀具，但没有 {tool}。\n\
            图形中的刀具是推测的，不检查刀杆碰撞。请在设置中加上 {tool}。",
        RapidThroughStock => "快速移动在 X{x} Z{z} 处撞到工件。\n\
            快速移动时刀具不能碰到材料：先走到工件外面的点，或用 G01 切削。",
        DoglegThroughStock => "两轴同时以快移速度起动时，这次快速移动会在 X{x} Z{z} 处撞到工件。\n\
            许多机床的 G00 不走直线，行程短的轴先到。请让两轴先后移动。",
        RapidAlongStock => "快速移动贴着毛坯外圆 X{x} 滑过。\n\
            至少留出 1 毫米：棒料直径可能比公称尺寸略大。",
        IntoJaws => "刀具在 X{x} Z{z} 处撞到卡盘。\n\
            请检查 Z 的正负号和数值，或毛坯的夹持长度（`grip`）。",
        IntoTailstock => "刀具在 X{x} Z{z} 处撞到尾座。\n\
            请绕开顶尖：先移动 X，再移动 Z。",
        HolderInStock => "刀杆在 X{x} Z{z} 处碰到工件。\n\
            切削深度超过刀具的伸出长度。请换较长的刀具，或从外面逐层切削。",
        SlopeTooSteep => "轮廓下降 {slope}°，而这把刀的副切削刃只允许 {follows}°。\n\
            副切削刃会切掉轮廓旁的材料。请用刀尖角较小的刀片，或从另一侧切削。",
        BelowCenter => "切削到 X{x}，超过了主轴中心。\n\
            车端面到 X0 为止，或再过一个刀尖圆弧半径，X 值为其两倍。再往前，刀刃会与反向运动的工件摩擦。",
        OverTravel => "{axis}{to} 超出机床行程，行程到 {axis}{limit} 为止。\n\
            系统会在那里停止并报警。请检查数值的正负号和小数点，或设置中的行程。",
    }
}

pub(super) const fn phrase(phrase: Phrase) -> &'static str {
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
