//! The messages in English.

use super::phrases::Phrase;
use super::wording::Wording;

/// The message, and on a second line its help.
#[rustfmt::skip] // One line each.
pub(super) const fn sentence(wording: Wording) -> &'static str {
    use Wording::*;
    match wording {
        NumberMissing => "`{address}` has no number.\n\
            Every address letter needs a value behind it. A remark belongs in brackets: `( … )`.",
        AddressMissing => "The number `{number}` has no address letter.\n\
            Put the letter it belongs to in front of it, such as X, Z or F.",
        NotUnderstood => "`{text}` does not belong to any word.\n\
            Was a sign misread or lost here? A remark belongs in brackets: `( … )`.",
        PlainText => "`{text}` is plain text, not a block.\n\
            A control stops here with an alarm. Put remarks in brackets: `( … )`.",
        SecondPoint => "`{word}` has two decimal points.\n\
            Delete one of them; check which number was meant.",
        TooManyDigits => "`{word}` has more than 8 digits.\n\
            Controls take up to 8 digits in a number, the decimals included.",
        BlankInNumber => "`{written}` has a blank inside its number; a control reads `{joined}`.\n\
            Delete the blank, or put in the letter that was lost.",
        LetterForDigit => "`{word}` has a letter where the digit {digit} belongs.\n\
            The letter O and the digit 0, and l and 1, look alike; the control knows the difference.",
        ZeroForO => "`{number}` was read as a program number: the first character should be the letter O.\n\
            Program numbers begin with the letter O, not with a zero.",
        PrintedMinus => "This is a printed dash, not a minus sign; it was read as a minus.\n\
            A control does not know this character. Replace it with `-`.",
        FullWidth => "`{word}` is written in full-width characters; it was read as `{plain}`.\n\
            A control does not know these characters. Switch the keyboard to half width, or replace them.",
        CommaForPoint => "`{word}` has a comma where the decimal point belongs.\n\
            G-code writes decimals with a point.",
        CommentOpen => "This bracket is never closed; the rest of the line was taken as a comment.\n\
            Close the comment with `)`. A control may swallow the following blocks too.",
        CommentNested => "There are brackets inside this comment.\n\
            For a control the comment ends at the first `)`; what follows it would be read as words.",
        TextAfterSemicolon => "`{text}` behind the `;` was taken as a remark.\n\
            On a FANUC or GSK control `;` ends a block; a remark belongs in brackets: `( … )`.",
        BlockTooLong => "This block has more than {most} words.\n\
            Was a line end lost? The rest of the block is not read.",
        TextTooLong => "The text has {bytes} bytes; the playground reads up to {most}.\n\
            Split the program, or open only the part you want to see.",
        EmptyProgram => "There is no program yet.\n\
            Type or paste one, or pick an example from the gallery.",
        ProgramNumberZero => "O0 is not a program number.\n\
            Use a number from O1 to O9999.",
        DuplicateProgram => "O{number} stands here a second time.\n\
            A control keeps only one program under a number. Give one of them another free number, or delete it.",
        NoEnd => "The program ends without M30 or M02.\n\
            Put M30 at the end: without it the control stops with an alarm, and spindle and coolant keep running.",
        MoreMessages => "Messages not shown: {hidden}.\n\
            Mend the first ones; later ones are often their consequence.",
        TooManyMotions => "The program makes more than {most} motions; the rest is not shown.\n\
            Is an amount in a cycle far too small?",
        TooMuchWork => "The cycles take more than {most} steps to work out; what follows is not shown.\n\
            Each call of G70 to G73 reads its contour again. Call long contours less often, and correct the cycles that are refused.",
        Stopped => "The run was stopped after {seconds} s; what follows is not shown.",
        CallNoNumber => "{code} does not say what it calls.\n\
            P gives the number of the program: M98 P1000 calls O1000, M98 P1000 L3 calls it three times.",
        ProgramNotFound => "No program of the number in `{word}` stands in this text, so the call is passed over.\n\
            Put the subprogram behind the main program: O and its number, its blocks, M99. Without L, digits in front of the last four are the repeats: P51002 is five times O1002.",
        SequenceNotFound => "No block N{sequence} stands in this program, so the jump is passed over.\n\
            The search stays within the O program it starts in.",
        CallTooDeep => "More than {most} calls stand one within the other; the run ends here.\n\
            A program that calls itself, or two that call each other, never end.",
        NoReturn => "This subprogram ends without M99.\n\
            A control stops here with an alarm. The picture goes on behind the call.",
        EndlessMain => "Run as a main program, this one begins again at M99, for ever; one round is drawn.\n\
            That is usual with a bar feeder. As a subprogram, called by M98 from another, it would return to its caller. Write M30 to end the program.",
        TooManyRepeats => "From here more than {most} blocks were run by jumps, loops and calls; the run ends.\n\
            The loop has no end, or far too many rounds. Look at what should end it: its condition, its counter, or L of the call.",
        TooMuchRepeated => "From here jumps, loops and calls ran through more than {most} characters of blocks; the run ends.\n\
            The loop has no end, or far too many rounds of long blocks. Look at what should end it: its condition, its counter, or L of the call.",
        TooManyRounds => "Loops and calls have made more than {most} rounds; the run ends here.\n\
            Look at what should end this loop: its condition, its counter, or L of the call.",
        TooManyMacroSteps => "More than {most} macro statements and expressions were worked out in jumps, loops and calls; the run ends here.\n\
            Look at what should end the loop, or let it work out less in each round.",
        NotRun => "O{number} is not run: no program calls it.\n\
            A text with several programs runs the first. Choose another one to see it.",
        NumberFromVariable => "`{word}`: N and O cannot take their number from a variable.\n\
            Write the number out. GOTO, P and Q may name it by a variable.",
        MacroOverflow => "This value is too large to be a number of a macro.",
        MacroDivisionByZero => "This divides by zero.\n\
            A vacant variable counts as 0: was another variable meant, or is one never set?",
        MacroUnknownFunction => "There is no such function.\n\
            SIN COS TAN ASIN ACOS ATAN SQRT ABS ROUND FIX FUP LN EXP POW MOD, with their values in `[ ]`.",
        MacroExpression => "This expression cannot be read.\n\
            Write `#1+2`, `[#1-#2]*3`, `SIN[#4]`: square brackets, a sign between any two values. Comparisons are EQ NE GT GE LT LE, not `=` and `>`.",
        MacroBracketOpen => "This `[` has no `]`.\n\
            Put `]` where what belongs together ends: `[#1-#2]/2` and `[#1-#2/2]` differ.",
        MacroNumberOrCondition => "A condition stands where a number belongs, or a number where a condition belongs.\n\
            A condition compares: `[#1 GT 10]`, with EQ NE GT GE LT LE.",
        MacroVariableNumber => "There is no such variable.\n\
            Local #1 to #33, common #100 to #199 and #500 to #999, system variables from #1000 on.",
        MacroReadOnly => "This variable can only be read, not written.\n\
            #0 is always vacant, and some system variables belong to the machine. Store in #1 to #33 or #100 to #199.",
        MacroBracketsTooDeep => "More than five brackets stand inside each other.\n\
            Take out a pair that changes nothing, or put a part into a variable first.",
        MacroFunctionArgument => "The function has no result for this value.\n\
            Such as the root or the logarithm of a negative number.",
        MacroEndMissing => "This DO has no END of the same number.\n\
            Write END with that number behind the last block that is to be repeated.",
        MacroFormat => "This macro statement cannot be read.\n\
            Such as `#1=#2+1`, `IF[#1 GT 5]GOTO 10`, `IF[#1 EQ 0]THEN #2=1`, `WHILE[#1 LE 9]DO1` … `END1`.",
        MacroLoopNumber => "The number of a loop is 1, 2 or 3, and END belongs to a DO that runs.",
        MacroWordsBehind => "A macro statement must have its block to itself.\n\
            Put the words of the machine in a block of their own.",
        MacroJumpTarget => "GOTO needs a sequence number from 1 to 99999999, without the letter N: `GOTO 10`.",
        MacroArgumentLetter => "This letter cannot hand an argument to a macro.\n\
            G, L, N, O and P cannot be used.",
        MacroAlarm => "The program stops itself with alarm {number}: {words}\n\
            #3000 raises an alarm of the program's own. It usually checks what it was given: look at the condition before it, and at the arguments of the call.",
        SystemVariable => "#{variable} is a variable of the machine that is not known here; it reads as vacant.\n\
            What depends on it may be drawn wrong.",
        ArgumentsUnknown => "This is the body of a macro: the argument in #{variable} is not known here.\n\
            What depends on the arguments is uncertain and not checked. Add a main program that calls it, such as `G65 P100 A1`.",
        ForeignMill => "This looks like a program for a milling machine.\n\
            The playground reads turning programs for FANUC and GSK lathes; nothing was run. Set `recognise` to false in the setup to run it all the same.",
        ForeignPrinter => "This looks like a program for a 3D printer.\n\
            The playground reads turning programs for FANUC and GSK lathes; nothing was run. Set `recognise` to false in the setup to run it all the same.",
        ForeignControl => "This looks like a program for {origin}, which is not supported here.\n\
            The same codes mean other things there, so nothing was run. The playground reads turning programs for FANUC and GSK. Set `recognise` to false in the setup to run it all the same.",
        SystemGuessed => "Read as G-code system {system}: this word does not belong to system A.\n\
            In systems B and C, G90 and G91 are absolute and incremental, G92 sets coordinates or the speed limit, and G77 G78 G79 (B) are the cycles. Choose the system in the setup to be sure.",
        LeastMillimetres => "No point = 0.001 mm: `{word}` is {value} mm.\n\
            The program looks as if it was written for a control on which numbers without a point count least input increments (FANUC parameter 3401#0 is 0). Set `decimal` in the setup to be sure.",
        LeastInches => "No point = 0.0001 in: `{word}` is {value} in.\n\
            The program looks as if it was written for a control on which numbers without a point count least input increments (FANUC parameter 3401#0 is 0). Set `decimal` in the setup to be sure.",
        LeastSeconds => "No point = 0.001 s: `{word}` is {value} s.\n\
            The program looks as if it was written for a control on which numbers without a point count least input increments (FANUC parameter 3401#0 is 0). Set `decimal` in the setup to be sure.",
        TooLargeMillimetres => "`{word}` counts as {value} mm here, too large to be meant.\n\
            Numbers without a point count whole units in this run; this program seems to mean least input increments by them (0.001 mm, 0.0001 in, 0.001 s). Set `decimal` in the setup, or write the point.",
        TooLargeInches => "`{word}` counts as {value} in here, too large to be meant.\n\
            Numbers without a point count whole units in this run; this program seems to mean least input increments by them (0.001 mm, 0.0001 in, 0.001 s). Set `decimal` in the setup, or write the point.",
        TooLargeSeconds => "`{word}` counts as {value} s here, too long to be meant.\n\
            Numbers without a point count whole units in this run; this program seems to mean least input increments by them (0.001 mm, 0.0001 in, 0.001 s). Set `decimal` in the setup, or write the point.",
        ReferenceNumber => "`{word}` names no reference point of G30.\n\
            P2, P3 and P4 are the second to fourth point; the first is reached by G28, without P.",
        NotAtReference => "G27 does not end at the reference point, X{x} Z{z} here.\n\
            G27 checks that the tool stands there, and raises an alarm where it does not.",
        NoIntermediate => "G29 has no intermediate point: no G28 or G30 came before.\n\
            G29 comes back from G28 by the same point. Write G28 before it, or go there with G00.",
        MachineZero => "G53 counts from the machine's own zero; here the reference point X{x} Z{z} is taken for it.\n\
            The program need not change. To draw the move in its place, set `refPoint` in the setup to where the slides stand at home.",
        OffsetNumber => "`{word}` names no entry of the offset table.",
        TipNumber => "`{word}` is no tip direction: 0 to 9.",
        DataPassedOver => "What follows up to G11 is data for the control's tables; it is passed over.\n\
            Nothing needs changing if that is meant; if G11 stands too late, move it up.",
        HoleInForce => "`{word}` may not stand while {hole} is in force.\n\
            Write G80 before it: until then every X, Z or C makes another hole.",
        PeckZero => "`{word}` is no depth of a peck.\n\
            Q is the depth of each peck in micrometres, as in Q5000. Without Q the hole is drilled in one cut.",
        HoleNoDepth => "{code} has no depth.\n\
            G83 G84 G85 need Z or W, G87 G88 G89 need X or U for the bottom of the hole.",
        HoleOfOthers => "{code} is not in FANUC's system A; it is drawn as on lathes that have it.\n\
            It drills along Z from the start point and back. FANUC turning controls drill with G83, or with G74.",
        UnknownG => "`{word}` is not a G code of this control.\n\
            The whole block is not carried out. Check the number.",
        UnknownM => "`{word}` is known only to some machines; it is passed over.\n\
            The machine's own manual says what it does.",
        NotSupported => "{what} is not supported here.\n\
            This is no fault of the program. Motions after it may be wrong and are drawn faint.",
        MakerG => "`{word}` depends on the machine; it is passed over.\n\
            Keep it if the machine's manual lists it; otherwise it is a slip: correct or delete it. What it does is not drawn.",
        PointNotAllowed => "`{word}` must be a whole number, without a point.",
        MinusNotAllowed => "`{word}` cannot be negative.",
        DuplicateWord => "{address} stands twice in this block; `{used}` counts.\n\
            The control takes the later one, or stops with an alarm. Delete the wrong one.",
        SameGroup => "`{dropped}` and `{used}` exclude each other; `{used}` counts.\n\
            Both belong to one modal group. In a block the last of a group is valid.",
        AbsoluteAndIncremental => "`{absolute}` and `{incremental}` name the same axis; `{used}` counts.\n\
            Controls differ here: FANUC takes the later word, GSK the absolute one.",
        ToolWithSetting => "`{word}` may not stand in one block with G50, G10 or G04.\n\
            Call the tool in a block of its own.",
        ToolWithHighestSpeed => "`{word}` stands in one block with G50 S: some controls stop there with PS0245.\n\
            Many older ones take it. To be safe, call the tool in a block of its own.",
        ShortTool => "`{word}` has no station number: it selects offset {offset} and leaves the turret where it is.\n\
            On a four-digit control write station and offset, such as T0101.",
        ToolNumber => "`{word}` is not a tool number.\n\
            Write station and offset, such as T0101.",
        ToolNumberOfMachine => "Whether `{word}` names a tool depends on the machine.\n\
            Machines with a tool changer or many offsets take such numbers; a turret takes station and offset, such as T0101.",
        G90AsAbsolute => "G90 on a lathe is the turning cycle, not absolute programming.\n\
            X and Z are always absolute here, U and W incremental. Here X or Z without a G code of its own starts a cycle: delete G90, or write G00 or G01 before them.",
        LetterIIsTaper => "I in G92 was read as the taper, as R.\n\
            FANUC reads I as the taper (the old spelling of R), GSK as threads per inch.",
        G28NoAxis => "{code} names no axis: on FANUC controls nothing moves; others send all axes there. Nothing is drawn.\n\
            Write U0 W0 behind {code} to send both axes there on all of them. Said once.",
        DwellWithPoint => "`{word}` has a point; it was read as seconds.\n\
            FANUC takes milliseconds without a point and raises an alarm here; Haas reads seconds. X or U give seconds everywhere.",
        DwellNoTime => "G04 has no time, so it does not wait.\n\
            Write X or U in seconds, or P in milliseconds, greater than zero: `G04 X0.5` or `G04 P500` is half a second. F is no time.",
        AxisNotHere => "The Y axis of `{word}` is not supported here: only X, Z and C are drawn.\n\
            The moves of X and Z are drawn all the same, faint from here on. Said once.",
        PlaneNotHere => "Arcs in the plane of {word} are not supported here outside G12.1.\n\
            Turning needs G18. Milling arcs on the end face are written under G12.1. Said once.",
        CAxisNotConnected => "C moves here, but nothing before has connected the C axis.\n\
            Which code does depends on the machine: M45 and G28 H0 on some. Under spindle control C raises an alarm.",
        LiveToolStopped => "A live tool cuts here, but nothing before has started it.\n\
            Which code does depends on the machine: M13 or M14 with S on some.",
        PolarForbidden => "`{word}` is not allowed between G12.1 and G13.1.\n\
            There only G01 G02 G03 G04 G40 G41 G42 G65 G66 G67 G98 G99 may stand: approach with G01, or leave by G13.1 first.",
        PolarFrame => "`{word}` changes coordinates between G12.1 and G13.1.\n\
            Set the zero point before G12.1: X0 must be the centre of the spindle.",
        PolarNotAlone => "{code} must stand alone in its block, without `{other}`.\n\
            Move the other words to a block of their own.",
        PlaneCompensation => "{code} stands under G41 or G42.\n\
            Compensation begins and ends inside: behind G12.1 or G07.1 C…, and by G40 before G13.1 or G07.1 C0.",
        PolarFeedPerTurn => "Feed per turn (G99) makes no sense in polar interpolation.\n\
            The spindle only positions there: write G98 and F in mm per minute.",
        PolarNoRadius => "G41 or G42 has no cutter radius here, so nothing is compensated.\n\
            Give the offset of the tool a radius; then the cutter's centre keeps that distance from the path.",
        PolarRadiusUnknown => "No cutter radius is known for offset {offset}; the picture shows the path uncompensated.\n\
            The offset table of the machine may hold it. Give it in the setup to see the compensated path.",
        PolarAngle => "`{word}` looks like degrees; between G12.1 and G13.1 C is a length in mm.\n\
            The path is written in a plane: X as a diameter to the right, C in mm upwards.",
        PolarCenter => "The path comes within {distance} {mm} of the spindle axis, where C would have to turn without bound.\n\
            A control slows down there or stops with an alarm. Keep away from the centre.",
        PlaneLeftOn => "Interpolation with C is still on at `{code}`.\n\
            Write {off} in a block of its own before.",
        CylinderFormat => "G07.1 needs C with the radius of the cylinder, and nothing else.\n\
            G07.1 C30 begins with a radius of 30 mm, G07.1 C0 ends it. It may not be begun twice.",
        CylinderForbidden => "`{word}` is not allowed in cylindrical interpolation.\n\
            There only G01 to G04 and G40 to G42 may stand, arcs are given by R, and rapids come before G07.1 or behind G07.1 C0.",
        FeedMissing => "There is no feed: no F other than zero has been given before this cut.\n\
            Fresh from power-on a control stops here; otherwise it cuts with the F of the program before. Add an F word, such as F0.2 under G99 (mm per turn) or F200 under G98 (mm per minute).",
        LeadMissing => "{code} has no lead.\n\
            F gives the lead of the thread in mm.",
        FeedPerTurnTooLarge => "`{word}` under G99 is {feed} {mm} per turn of the spindle.\n\
            That is far too much for a cut. Was G98 (mm per minute) meant? Set the control's feed mode, or write G98.",
        FeedPerMinuteTooSmall => "`{word}` under G98 is only {feed} {mm} per minute.\n\
            Was G99 (mm per turn) meant? Set the control's feed mode, or write G99.",
        FeedNotRepeatedPerTurn => "After G99 the old feed of {feed} now counts as {mm} per turn.\n\
            Write F anew whenever the feed mode changes.",
        FeedNotRepeatedPerMinute => "After G98 the old feed of {feed} now counts as {mm} per minute.\n\
            Write F anew whenever the feed mode changes.",
        SpindleStopped => "The tool cuts while the spindle stands still.\n\
            Start the spindle with M03 or M04 and a speed S greater than zero before the first cut.",
        NoSpeedClamp => "G96 without a highest spindle speed.\n\
            Towards the centre the speed rises without bound. Give a limit first, such as G50 S2000.",
        ClampReversed => "The lowest spindle speed Q{lowest} is above the highest S{highest}.",
        ThreadAtSurfaceSpeed => "{code} cuts a thread under G96, where the spindle speed changes with X.\n\
            Every pass must meet the same groove: give a constant speed with G97 S….",
        ArcNoCenter => "{code} has neither R nor I, K.\n\
            Give the radius with R, or the centre from the start point with I and K; or was G01 meant? FANUC goes straight there unless a parameter asks for the alarm.",
        ArcRadiusTooSmall => "`{word}` is too small: start and end of the arc are {distance} {mm} apart.\n\
            The radius must be at least {least} {mm}, half the distance. X counts as a diameter.",
        ArcEndOffCircle => "The end point is not on the circle: the centre is {start_radius} {mm} from the start but {end_radius} {mm} from the end.\n\
            I is a radius value from the start point to the centre, K the same along Z; both have a sign.",
        ArcNoRadius => "I and K are zero: the centre is the start point, so the arc has no radius.\n\
            I is a radius value from the start point to the centre, K the same along Z; or give the radius with R.",
        ArcRadiusNegative => "This control does not take `{word}`.\n\
            Write R without the minus for the short arc; give arcs of more than 180° with I and K.",
        ArcNowhere => "The arc ends where it begins, so with R nothing moves.\n\
            A full circle is written with I and K.",
        TaperBeyondHalf => "`{word}` is larger than half of `{axis}{limit}`: the cut would begin outside the start point.\n\
            When R and the way to the end point have different signs, the start of the cut must not lie beyond the start point.",
        TaperBeyondLength => "`{word}` is larger than the length of `{axis}{limit}`: the cut would begin outside the start point.\n\
            When R and the way to the end point have different signs, the start of the cut must not lie beyond the start point.",
        TaperNotExtended => "From this start point R{taper} meets the edge of the stock at {axis}{crossing}; for {axis}{wanted} it would be R{needed}.\n\
            R counts from the start point, which lies outside the stock. Is R{taper} the height of the cone on the drawing? Then extend it in proportion. If it was worked out for this start point, it is right.",
        ContourNotNamed => "{code} needs both P and Q.\n\
            P names the first block of the contour by its N number, Q the last.",
        ContourNotFound => "No block has the number that `{word}` names.\n\
            P names the first block of the contour, Q the last, which must stand behind it in the same program.",
        ContourReversed => "The block that `{word}` names stands before N{first}, which P names.\n\
            P names the first block of the contour, Q the last. Were P and Q exchanged?",
        ContourFirstBlock => "The first block of the contour of {code} does not move by G00 or G01.\n\
            It takes the tool from the start point to where the contour begins.",
        ContourIllegal => "`{word}` may not stand between P and Q.\n\
            A contour holds moves by G00, G01, G02 and G03 only. The cycle is not carried out.",
        ContourReachesOver => "P and Q of {code} take in another operation: `{word}` in line {line}.\n\
            Look at the sequence numbers: one may stand twice, or Q may name a block far behind. The cycle is not carried out.",
        ContourCall => "`{word}` calls a subprogram inside a contour.\n\
            Write the moves out between P and Q. The cycle is not carried out.",
        ContourBothAxes => "The first block of the contour of {code} names {other} too, though it does not move.\n\
            Controls take two axes there as type II (pockets). Leave the word out for type I.",
        ContourTypeTwo => "The first block of the contour of {code} moves both axes, which this control does not take.\n\
            Without pockets (type II) only one axis may move there.",
        ContourTurnsBack => "The contour of {code} goes back or deeper in {axis} at line {line}.\n\
            Type I takes contours that go one way in both axes; type II, with two axes in the first block, allows pockets in depth.",
        ContourBeyondStart => "The contour of {code} goes beyond the start point in {axis}.\n\
            Start the cycle outside the contour.",
        ContourNothingToCut => "Between the start point and this contour there is nothing for {code} to cut.\n\
            Its first block must go to a diameter (G72: a length) below the start point, and more than one further move must follow.",
        ContourOpenEnd => "`{word}` in the last block of the contour has no next move.\n\
            A contour cannot end in a chamfer, a rounded corner or an open angle.",
        DepthMissing => "{code} has no depth of cut.\n\
            Give it in a first block, such as G71 U2 R0.5 or G72 W2 R0.5. U or W beside P and Q is the allowance.",
        DepthNotPositive => "The depth of cut {depth} of {code} must be larger than zero.\n\
            It has no sign: the cycle finds its direction from the contour. Digits below 0.001 mm do not count.",
        AllowanceSign => "The allowance `{word}` points into the part.\n\
            Outside work has a positive U, bores a negative one; W points away from the direction of cut.",
        PatternNoPasses => "G73 has no number of passes.\n\
            R of a first block is the number of passes, U (radius) and W the material to take off, such as G73 U9 W2 R5.",
        PatternPasses => "G73 cannot make {passes} passes.",
        TooManyPasses => "{code} would make more than {most} moves; it is not carried out.\n\
            Is the depth, the peck or the first cut far too small? Amounts without a point may be micrometres.",
        PeckNegative => "`{word}` cannot be negative.\n\
            Pecks and steps have no sign: the direction follows from the end point.",
        PeckMissing => "{code} moves this axis but has no {address}.\n\
            P is the amount along X (radius), Q along Z, in micrometres: P3000 is 3 mm.",
        ReliefNegative => "The relief or retract `{word}` cannot be negative here.\n\
            Its direction follows from the steps.",
        AmountInMillimetres => "`{word}` was read as mm (inches under G20).\n\
            FANUC and GSK controls count P and Q in micrometres, without a point: 5 mm is 5000. Set pqUnit to decide.",
        ThreadAngle => "{angle}° is no tool angle of G76.\n\
            FANUC takes 80, 60, 55, 30, 29 and 0 degrees: the last two digits of P.",
        ThreadLeastDepth => "The least depth {least} {mm} is larger than the thread height {height} {mm}.\n\
            Q of the first block is the least depth of a pass in micrometres, usually 20 to 100; P of the second is the height.",
        ThreadNoHeight => "G76 needs a thread height P larger than zero.\n\
            P is the height of the thread, about 0.65 of the pitch (P1300 for 2 mm), Q the depth of the first cut, both as radius values in micrometres.",
        ThreadNoFirstDepth => "G76 needs a first depth Q larger than zero.\n\
            P is the height of the thread, Q the depth of the first cut, both as radius values in micrometres.",
        ThreadStartInside => "G76 starts at X{start}, at or inside the crest of the thread at X{crest}.\n\
            The tool returns to the start X after every pass: it must clear the work.",
        ThreadStartAtCrest => "G76 starts at X{start}, just where its P puts the crest of the thread.\n\
            The tool returns to the start X after every pass. It clears the work only where that was turned smaller.",
        CornerNoMove => "`{word}` has no straight move behind it to form a corner with.\n\
            The next block must move by G01 (on GSK, `L` and `D` may also stand before G02 and G03).",
        CornerTooLarge => "`{word}` is larger than the moves beside it.\n\
            It takes that much of each move; X counts as a diameter, so X46 to X50 is a way of 2 mm. Write a smaller corner, or lengthen the move.",
        CornerNone => "`{word}`: these two moves form no corner.\n\
            The path turns back on itself. Put the word into the block where it turns, or delete it.",
        CornerStraight => "`{word}`: the next move goes straight on, so nothing is inserted.\n\
            Moves less than 1° apart form no corner for the control. Put the word into the block where the path turns, or delete it.",
        CornerNoLine => "`{word}`: there is no corner in this block.\n\
            A chamfer or a rounded corner needs a move by G01 (G02 and G03 for `,C` and `,R`); rapids and cycles have none.",
        CornerAxis => "`{word}` does not fit the next move.\n\
            Without a comma, a chamfer or radius joins a move along one axis to a move along the other; its sign is the direction of the next move.",
        CornerTwice => "`{word}` and `{other}` both ask for a corner; a block can have one.",
        CornerInThread => "`{word}`: a thread cannot end in a chamfer or a rounded corner.\n\
            Put the corner into a block with G01.",
        CornerWithCompensation => "`{word}` stands where compensation begins or ends.\n\
            Put G40, G41 and G42 into a block without a corner.",
        CyclePlane => "{code} works only in the plane G18.\n\
            Write G18 before it.",
        CycleWord => "`{word}` may not stand in a block with {code}.\n\
            The end of the contour is in its blocks P to Q; the cycle takes P, Q, U, W and F, S, T.",
        CycleAxis => "`{word}`: {code} moves only X and Z.\n\
            Move this axis in a block of its own before the cycle.",
        FinishStart => "G70 does not start where the contour was roughed from, X{roughed_x} Z{roughed_z}.\n\
            The first and the last move are rapids: from another point they may cross the part.",
        FinishWithoutRoughing => "The contour N{first} to N{last} is finished by G70, but no G71, G72 or G73 roughs it.\n\
            Is the blank near the finished size, or do P and Q name the wrong blocks?",
        AngleNoPoint => "`{word}` leads to no point.\n\
            Angles count from +Z, counter-clockwise. Two lines must cross; one line needs X or Z beside its angle.",
        CompensationOnArc => "{code} may not begin or end on an arc.\n\
            Put G40, G41 and G42 on a straight move (G00 or G01).",
        CompensationOvercut => "A nose of R{radius} does not fit here: it would cut into the contour.\n\
            A step is lower, a groove narrower or an inner arc smaller than the nose. Take an insert with a smaller nose, or make that place at least as large as the nose.",
        CompensationNoIntersection => "With a nose of R{radius} these two moves do not meet.\n\
            Check the end point and the radius of both: shifted by the nose radius they must still cross.",
        CompensationPlane => "The plane may not change while G41 or G42 is on.\n\
            Write G40 first, on a move before the plane changes.",
        LeadRunsOut => "With `{word}` the lead of G34 is zero after {reached} {mm}, and the thread is {length} {mm} long.\n\
            K is the change of lead for each turn; it must leave the lead positive to the end.",
        CompensationIdle => "Nose radius compensation is on, but it is not applied in this {code}.\n\
            Threads and grooves are cut without it, roughing on most controls too; G90 and G94 need a nose radius in the tool's offset.",
        LeadingZero => "`{word}` counts as {value}: a zero in front changes nothing.\n\
            A decimal point was probably lost: `{meant}`. Without it the number is ten times or more too large.",
        PointMissing => "`{word}` has no decimal point, though the program writes all others with one.\n\
            Was a point lost? A control that counts least increments reads it as {thousandths} {mm}.",
        FarOff => "`{word}` leads to {axis}{to}, far beyond the rest of the program, which stays within {farthest} {mm} of {axis}0.\n\
            Was a decimal point lost, or a digit typed twice?",
        MinusMissing => "`{word}` cuts away from the chuck, in front of the work.\n\
            Was the minus lost? `{meant}` would cut into the work. In front of the face there is only air.",
        IncrementalForAbsolute => "`{word}` counts from where the tool stands and leads to {axis}{to}.\n\
            U and W are increments, X and Z places. The rest of the program writes places: was `{meant}` meant?",
        SpeedMissing => "The tool cuts, but no spindle speed S was given.\n\
            Write S with G97 (turns a minute) or G96 (metres a minute, feet under G20) before the first cut, such as G97 S800 M03.",
        SurfaceSpeedMissing => "The tool cuts under G96, but G96 has no S of its own.\n\
            The S before was turns a minute under G97. Write the cutting speed beside G96, such as G96 S120.",
        SpeedNotRepeated => "{code} without S: the spindle keeps the {speed} turns a minute that it reached last.\n\
            S counts metres a minute under G96 (feet under G20), turns a minute under G97. Write S anew with {code}.",
        ThreadTooFast => "S{speed} is too fast for a pitch of {pitch} {mm}: the slides follow up to about {limit} turns a minute.\n\
            The rule is n ≤ 1200/P − 80. Above it the thread loses its pitch at both ends.",
        ThreadSpeedChanged => "The spindle speed changes from {before} to {now} between two passes of one thread.\n\
            The passes then do not meet in the same groove. Keep one speed from the first to the last pass.",
        ThreadStartMoved => "This pass starts at Z{now}, the one before at Z{before}: the threads do not meet.\n\
            The difference must be a multiple of the lead {lead} {mm}, or Q must give the angle of another start.",
        ThreadRunIn => "The run-in of {have} {mm} is short for this speed and lead: about {need} {mm} are needed.\n\
            While the slide speeds up the pitch is wrong. Start farther in front, or turn slower.",
        ThreadHeight => "A thread height of {height} {mm} does not fit a pitch of {pitch} {mm}; about {usual} {mm} are usual at 60°.\n\
            P is the height on one side (radius), in micrometres: 0.65 of the pitch or so. Was the diameter given, or a digit lost?",
        ThreadFirstDepth => "The first cut of {first} {mm} is deeper than the whole thread of {height} {mm}.\n\
            P is the height, Q the first depth, both as radius values in micrometres. Did they change places?",
        ThreadLeastLarge => "`{word}` makes the least depth of a pass {least} {mm}.\n\
            Q of the first block is in micrometres, usually 20 to 100. The digits for finishing, pull-out and angle belong to P.",
        ThreadPullOut => "The pull-out of {pull_out} {mm} is longer than the way of {way} {mm} back to the start diameter.\n\
            At 45° the tool would leave the start point behind. Start farther outside, or make r in the first P smaller.",
        FeedOfThread => "{feed} {mm} is still the lead of the thread before; now it is the feed of this cut.\n\
            Write F anew for turning after a thread: {feed} {mm} a turn would break the tool.",
        LeadOfFeed => "{code} has no F of its own: the feed of {feed} {mm} of the cut before becomes the lead of the thread.\n\
            Write the lead with {code}, such as F1.5.",
        TaperNarrows => "With `{word}` the cone becomes narrower toward the chuck.\n\
            Outside cones that grow toward the chuck have a negative R, bores that narrow toward it a positive one: R is the start of the cut minus its end, in radius. Was the sign meant?",
        TaperCrossesAxis => "With `{word}` the cut begins at X{x}, beyond the spindle axis.\n\
            R is a radius difference: X of the end plus twice R is the start of the cut. Check sign and point of R.",
        TaperEdge => "This pass of the taper is {depth} {mm} deep at its thin end.\n\
            With a taper the depth differs along the cut. Begin farther outside and come nearer pass by pass.",
        PassNotDeeper => "`{word}` is less deep than an earlier pass at {axis}{deepest}: it cuts air.\n\
            Each pass of the cycle should go deeper. Was a digit misread, or the order of the lines changed?",
        AirCut => "The cycle starts {distance} {mm} away from the work in {axis}; each pass repeats this way at feed.\n\
            Start 1 to 3 mm outside the blank.",
        StartBehindFace => "The cycle starts at Z{z}, behind the face of the blank at Z{face}.\n\
            G90 and G94 leave the material in front of it; G92 and G76 go into the work at rapid. Start in front of the face.",
        StartInStock => "{code} starts at X{x}, within the material.\n\
            The tool comes back to the start diameter at rapid after each pass: it must lie outside the material.",
        ToolChangeNear => "The tool changes to {tool} at X{x} Z{z}, close to the work.\n\
            The other tools of the turret swing around there. Go to the change point first, such as X200 Z200; boring bars need more room.",
        BoreRetract => "The rapid out of the bore runs into its wall at X{x} Z{z}.\n\
            Leave the wall towards smaller X first, then go out along Z alone, and only then to the change point.",
        GrooveStep => "`{word}` is a step of {step} {mm}, not smaller than the blade of {width} {mm}: ridges stay between the cuts.\n\
            The cuts must overlap: make Q smaller than the width of the blade.",
        EscapeTooLarge => "The retract `{word}` is larger than the depth of cut, {depth} {mm}.\n\
            After each pass the tool lifts by R at 45°; half a millimetre is usual.",
        ContourStartMoved => "The contour begins at {axis}{first}, but {code} starts at {axis}{start}.\n\
            The first block should move the other axis only: both points share {axis}.",
        ContourNotClosed => "The contour ends at X{x}, within the blank of Ø{diameter}: a step of material stays there.\n\
            Let the last block go out to the start diameter, so that the tool leaves the work.",
        PatternShallow => "The first pass of G73 is {depth} {mm} deep: the relief of {relief} {mm} is less than the material to take off.\n\
            U of the first block is the whole depth to remove, as a radius: stock minus thinnest diameter, halved.",
        PatternAir => "{share} % of the first pass of G73 run outside the blank.\n\
            G73 repeats a shape, for castings and forgings. From a bar G71 is quicker.",
        CompensationInCycle => "`{word}` stands in a block of {code}: compensation cannot be switched in the middle of a cycle.\n\
            Switch compensation in a block of its own, on the move to the start point and behind the last pass.",
        CompensationLeftOn => "{code} is still on at `{word}`.\n\
            The path is shifted by the nose radius until G40. Cancel it on a move away from the work first.",
        CompensationSide => "{code} puts the nose on the side of the material here; {right} belongs to this cut.\n\
            Toward the chuck, outside work needs G42 and bores G41; the other way round they change.",
        CompensationTurnsBack => "The path turns straight back under {code}: the nose goes over to its other side.\n\
            It cuts into what it has just turned, by up to twice its radius. Lead the tool off the contour first, or cancel with G40.",
        CompensationIdleBlocks => "Two blocks without a move stand one behind the other while compensation is on.\n\
            The control looks only a few blocks ahead; without a next move it cuts too much or too little at the corner. Put such blocks elsewhere.",
        CompensationShort => "The move of {length} {mm} that begins or ends compensation is shorter than the nose radius {radius} {mm}.\n\
            Give it at least the radius, better twice, outside the material.",
        CompensationTip => "The tool's tip number is {tip}, so the control takes the centre of the nose for its tip.\n\
            Turning tools have 3, boring bars 2: `tip` of the setup, or TIP= in a TOOL comment, says where the imaginary tip lies.",
        ChuckOpen => "`{word}` opens the chuck on many machines, and the spindle still turns.\n\
            Stop it first with M05.",
        TapReverse => "The tap leaves the hole without the spindle turning back.\n\
            Thread in, M05 at the bottom, then M04 (M03 for left-hand threads), and out by G32 with the same F. A rapid tears the thread off.",
        TapSurface => "A tap on the axis needs a constant speed: G97 with S.\n\
            Under G96 the speed rises to the limit at X0.",
        DuplicateSequence => "N{sequence} stands a second time, in line {line}; the first behind this block is taken.\n\
            P, Q, GOTO and M99 P search by number. Give each block that is searched for a number of its own.",
        ArcOverHalf => "`{word}` is negative: the arc goes the long way round, more than 180°.\n\
            A turned profile hardly ever does. Was a positive R meant?",
        NotCompared => "The program has more than {most} blocks, or ten times as many motions: its numbers are not compared with each other.\n\
            Nothing is wrong with it; only a lost point, a lost minus or a U in place of an X is then not noticed. `limits.comparedBlocks` of the setup sets the bound.",
        CoolantOff => "This cut is made without coolant.\n\
            Switch it on with M08 before the first cut and off with M09 at the end.",
        FeedModeNotNamed => "Neither G98 nor G99 stands before this cut.\n\
            Then what F counts depends on how the control was left. Write G99 (mm a turn) or G98 (mm a minute) at the head.",
        ToolNotNamed => "This cut has no tool: no T word stands before it.\n\
            The turret may have any tool in place. Call one with its offset, such as T0101.",
        FeedOnlyForFinishing => "`{word}` stands in a contour: only G70 uses it.\n\
            G71, G72 and G73 rough with the F, S and T of their own block or before it.",
        StopBehindMove => "M05 stands in a block with a move: the spindle stops once the move is done.\n\
            Write M05 in its own block, before or behind the move.",
        SetupPositive => "`{key}` of the setup is {value}; it must be greater than zero.\n\
            The picture goes on without it: a blank, tool or tailstock with a wrong value counts as not given.",
        SetupNotNegative => "`{key}` of the setup is {value}; it cannot be negative.\n\
            The picture goes on without it: a blank, tool or tailstock with a wrong value counts as not given.",
        SetupBelow => "`{key}` of the setup is {value}; it must be less than {most}.\n\
            A bore fits inside the bar, and jaws hold less than the whole of it. A blank or tool with a wrong value counts as not given.",
        SetupAtMost => "`{key}` of the setup is {value}; it can be {most} at most.\n\
            Lengths are in millimetres, angles in degrees. A blank, tool or tailstock with a wrong value counts as not given.",
        NoteWord => "`{word}` is nothing a setup comment can say.\n\
            Here can stand: {expected}",
        PartTooManyMotions => "The program has more than {most} motions: the path is shown, but not the part, and no collision is looked for.\n\
            `limits.partMotions` of the setup sets the bound.",
        PartStopped => "The part was stopped after {done} of {all} motions: the path is shown, but not the part.\n\
            Change the program or its setup to begin again.",
        BehindLeftOut => "A block before was not carried out as it is written: from here on collisions with the work are not looked for.\n\
            What of the work still stands is not known. Mend that block first.",
        BehindLeftOutCuts => "A block before was not carried out as it is written: cuts that depend on it ({cuts}) are drawn faint and not taken off the part.\n\
            From here on collisions with the work are not looked for, for what of it still stands is not known. Mend that block first.",
        PartTooManyCorners => "The part has more than {most} corners: the path is shown, but not the part, and collisions are found up to there.\n\
            `limits.partCorners` of the setup sets the bound.",
        ElsewhereLeftOut => "The cuts from here on in another work frame ({cuts} in all) are not taken off the part: where its zero is, is not known.\n\
            It may be a second clamping, or the sub spindle. To see what they leave, put them into a program of their own.",
        ToolUnknown => "What kind of tool {tool} is, is not known: the path is shown, but not the part.\n\
            Each usual insert or blade would cut into the contour here. Describe the tool in the setup or in a comment, such as `(TOOL {tool} TYPE=GROOVING WIDTH=3)`.",
        ToolNotListed => "The setup names tools, but not {tool}.\n\
            A tool is guessed for the picture; no collision of its holder is found. Add {tool} to the setup.",
        RapidThroughStock => "The rapid runs into the work at X{x} Z{z}.\n\
            A rapid must stay clear of material: go to a point outside first, or cut there at feed (G01).",
        DoglegThroughStock => "Where both axes start at rapid rate together, this rapid runs into the work at X{x} Z{z}.\n\
            Many machines do not move in a straight line with G00: the shorter axis arrives first. Move one axis after the other.",
        RapidAlongStock => "The rapid slides along the outside of the blank at X{x}.\n\
            Stay at least one millimetre clear: the bar may be a little larger than nominal.",
        IntoJaws => "The tool runs into the chuck at X{x} Z{z}.\n\
            Check the sign and length of Z, or how far the blank stands out of the jaws (`grip`).",
        IntoTailstock => "The tool runs into the tailstock at X{x} Z{z}.\n\
            Go around the centre: X first, then Z.",
        HolderInStock => "The holder of the tool runs into the work at X{x} Z{z}.\n\
            The cut is deeper than the tool reaches. Take a longer tool, or cut in steps from outside.",
        SlopeTooSteep => "The contour falls by {slope}°, but the edge behind the tip lets this tool follow only {follows}°.\n\
            The trailing edge takes off material beside the contour. Use an insert with a smaller point angle, or cut from the other side.",
        BelowCenter => "The cut goes to X{x}, beyond the spindle axis.\n\
            Facing ends at X0, or past it by the nose radius, in X twice as much. Beyond that the edge rubs against work that moves the other way.",
        OverTravel => "{axis}{to} is beyond the travel of the machine, which ends at {axis}{limit}.\n\
            The control stops there. Check sign and point of the number, or the travel in the setup.",
    }
}

pub(super) const fn phrase(phrase: Phrase) -> &'static str {
    use Phrase::*;
    match phrase {
        CloseComment => "Close the comment",
        DecimalPoint => "Write a decimal point",
        LetterO => "Write the letter O",
        Minus => "Write a minus",
        Write => "Write `{text}`",
        Delete => "Delete `{text}`",
        Insert => "Insert `{text}`",
        AsCycle => "Write these four moves as {cycle}",
        AsCyclePasses => "Write these {passes} passes as {cycle}",
        Rapid => "rapid to {to}",
        Feed => "feed to {to}",
        ArcClockwise => "arc G02 to {to}",
        ArcCounterclockwise => "arc G03 to {to}",
        Thread => "thread to {to}",
        Dwell => "dwell to {to}",
        DwellFor => "dwell {seconds} s at {to}",
        Infeed => "infeed",
        Cut => "cut",
        PullOut => "pull-out",
        Retract => "retract",
        Return => "return",
        Approach => "approach",
        Escape => "escape",
        Contour => "along the contour",
        Relief => "relief",
        Stepover => "step-over",
        AtRapid => "at rapid",
        WithSpindle => "in step with the spindle",
        AtFeed => "at feed",
        Pass => ", pass {pass}",
        PassOf => ", pass {pass} of {passes}",
        OfCycle => "{cycle}{pass}: {step} {manner} to {to}",
        CutOfCycle => "{cycle}{pass}: {step} {manner} to {to}",
    }
}
