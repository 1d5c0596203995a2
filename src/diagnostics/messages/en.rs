//! The messages in English.

use super::{Sentence, end_of, number};
use crate::control::macros::FaultKind;
use crate::control::origin::Origin;
use crate::diagnostics::message::Message;
use crate::motion::{Motion, MotionKind, Step};

pub(super) fn sentence(message: &Message) -> Sentence {
    match message {
        Message::NumberMissing { address } => Sentence::new(format!("`{address}` has no number."))
            .help("Every address letter needs a value behind it. A remark belongs in brackets: `( … )`."),
        Message::AddressMissing { number } => Sentence::new(format!("The number `{number}` has no address letter."))
            .help("Put the letter it belongs to in front of it, such as X, Z or F."),
        Message::NotUnderstood { text } => Sentence::new(format!("`{text}` does not belong to any word."))
            .help("Was a sign misread or lost here? A remark belongs in brackets: `( … )`."),
        Message::PlainText { text } => Sentence::new(format!("`{text}` is plain text, not a block."))
            .help("A control stops here with an alarm. Put remarks in brackets: `( … )`."),
        Message::SecondPoint { word } => Sentence::new(format!("`{word}` has two decimal points."))
            .help("Delete one of them; check which number was meant."),
        Message::TooManyDigits { word } => Sentence::new(format!("`{word}` has more than 8 digits."))
            .help("Controls take up to 8 digits in a number, the decimals included."),
        Message::BlankInNumber { written, joined } => {
            Sentence::new(format!("`{written}` has a blank inside its number; a control reads `{joined}`."))
                .help("Delete the blank, or put in the letter that was lost.")
        }
        Message::LetterForDigit { word, digit, .. } => {
            Sentence::new(format!("`{word}` has a letter where the digit {digit} belongs."))
                .help("The letter O and the digit 0, and l and 1, look alike; the control knows the difference.")
        }
        Message::ZeroForO { number } => {
            Sentence::new(format!("`{number}` was read as a program number: the first character should be the letter O."))
                .help("Program numbers begin with the letter O, not with a zero.")
        }
        Message::PrintedMinus => Sentence::new("This is a printed dash, not a minus sign; it was read as a minus.")
            .help("A control does not know this character. Replace it with `-`."),
        Message::CommaForPoint { word, .. } => Sentence::new(format!("`{word}` has a comma where the decimal point belongs."))
            .help("G-code writes decimals with a point."),
        Message::CommentOpen => Sentence::new("This bracket is never closed; the rest of the line was taken as a comment.")
            .help("Close the comment with `)`. A control may swallow the following blocks too."),
        Message::CommentNested => Sentence::new("There are brackets inside this comment.")
            .help("For a control the comment ends at the first `)`; what follows it would be read as words."),
        Message::TextAfterSemicolon { text } => Sentence::new(format!("`{text}` behind the `;` was taken as a remark."))
            .help("On a FANUC or GSK control `;` ends a block; a remark belongs in brackets: `( … )`."),
        Message::BlockTooLong { most } => Sentence::new(format!("This block has more than {most} words."))
            .help("Was a line end lost? The rest of the block is not read."),
        Message::TextTooLong { bytes, most } => {
            Sentence::new(format!("The text has {bytes} bytes; the playground reads up to {most}."))
                .help("Split the program, or open only the part you want to see.")
        }
        Message::EmptyProgram => {
            Sentence::new("There is no program yet.").help("Type or paste one, or pick an example from the gallery.")
        }
        Message::ProgramNumberZero => {
            Sentence::new("O0 is not a program number.").help("Use a number from O1 to O9999.")
        }
        Message::DuplicateProgram { number } => Sentence::new(format!("O{number} stands here a second time."))
            .help("A control keeps only one program under a number."),
        Message::NoEnd => Sentence::new("The program ends without M30 or M02.")
            .help("Put M30 at the end: without it the control stops with an alarm, and spindle and coolant keep running."),
        Message::MoreMessages { hidden } => Sentence::new(format!("{hidden} more messages are not shown."))
            .help("Mend the first ones; later ones are often their consequence."),
        Message::TooManyMotions { most } => {
            Sentence::new(format!("The program makes more than {most} motions; the rest is not shown."))
                .help("Is an amount in a cycle far too small?")
        }
        Message::TooMuchWork { most } => {
            Sentence::new(format!("The cycles take more than {most} steps to work out; what follows is not shown."))
                .help("Each call of G70 to G73 reads its contour again. Call long contours less often, and correct the cycles that are refused.")
        }
        Message::Stopped { seconds } => {
            Sentence::new(format!("The run was stopped after {} s; what follows is not shown.", number(*seconds)))
        }
        Message::CallNoNumber { code } => Sentence::new(format!("{code} does not say what it calls."))
            .help("P gives the number of the program: M98 P1000 calls O1000, M98 P1000 L3 calls it three times."),
        Message::ProgramNotFound { word } => {
            Sentence::new(format!("No program of the number in `{word}` stands in this text, so the call is passed over."))
                .help("Put the subprogram behind the main program: O and its number, its blocks, M99. Without L, digits in front of the last four are the repeats: P51002 is five times O1002.")
        }
        Message::SequenceNotFound { sequence } => {
            Sentence::new(format!("No block N{sequence} stands in this program, so the jump is passed over."))
                .help("The search stays within the O program it starts in.")
        }
        Message::CallTooDeep { most, .. } => {
            Sentence::new(format!("More than {most} calls stand one within the other; the run ends here."))
                .help("A program that calls itself, or two that call each other, never end.")
        }
        Message::NoReturn => Sentence::new("This subprogram ends without M99.")
            .help("A control stops here with an alarm. The picture goes on behind the call."),
        Message::EndlessMain => Sentence::new("M99 in a main program goes back to its head, for ever; one round is drawn.")
            .help("That is usual with a bar feeder. As a subprogram, called by M98 from another, it would return to its caller. Write M30 to end the program."),
        Message::TooManyRepeats { most } => {
            Sentence::new(format!("From here more than {most} blocks were run by jumps, loops and calls; the run ends."))
                .help("The loop has no end, or far too many rounds. Look at what should end it: its condition, its counter, or L of the call.")
        }
        Message::TooMuchRepeated { most } => {
            Sentence::new(format!("From here jumps, loops and calls ran through more than {most} characters of blocks; the run ends."))
                .help("The loop has no end, or far too many rounds of long blocks. Look at what should end it: its condition, its counter, or L of the call.")
        }
        Message::TooManyRounds { most } => {
            Sentence::new(format!("Loops and calls have made more than {most} rounds; the run ends here."))
                .help("Look at what should end this loop: its condition, its counter, or L of the call.")
        }
        Message::TooManyMacroSteps { most } => {
            Sentence::new(format!("More than {most} macro statements and expressions were worked out in jumps, loops and calls; the run ends here."))
                .help("Look at what should end the loop, or let it work out less in each round.")
        }
        Message::NotRun { number } => Sentence::new(format!("O{number:04} is not run: no program calls it."))
            .help("A text with several programs runs the first. Choose another one to see it."),
        Message::NumberFromVariable { word } => Sentence::new(format!("`{word}`: N and O cannot take their number from a variable."))
            .help("Write the number out. GOTO, P and Q may name it by a variable."),
        Message::Macro { kind } => macro_fault(*kind),
        Message::MacroAlarm { number, words } => {
            Sentence::new(format!("The program stops itself with alarm {number}: {words}"))
                .help("#3000 raises an alarm of the program's own. It usually checks what it was given: look at the condition before it, and at the arguments of the call.")
        }
        Message::SystemVariable { variable } => Sentence::new(format!("#{variable} is a variable of the machine that is not known here; it reads as vacant."))
            .help("What depends on it may be drawn wrong."),
        Message::Foreign { origin: Origin::Mill } => Sentence::new("This looks like a program for a milling machine.")
            .help("The playground reads turning programs for FANUC and GSK lathes; nothing was run. Set `recognise` to false in the setup to run it all the same."),
        Message::Foreign { origin: Origin::Printer } => Sentence::new("This looks like a program for a 3D printer.")
            .help("The playground reads turning programs for FANUC and GSK lathes; nothing was run. Set `recognise` to false in the setup to run it all the same."),
        Message::Foreign { origin } => Sentence::new(format!("This looks like a program for {}, which is not supported here.", origin.name()))
            .help("The same codes mean other things there, so nothing was run. The playground reads turning programs for FANUC and GSK. Set `recognise` to false in the setup to run it all the same."),
        Message::SystemGuessed { system } => {
            Sentence::new(format!("Read as G-code system {system:?}: this word does not belong to system A."))
                .help("In systems B and C, G90 and G91 are absolute and incremental, G92 sets coordinates or the speed limit, and G77 G78 G79 (B) are the cycles. Choose the system in the setup to be sure.")
        }
        Message::ReferenceNumber { word } => Sentence::new(format!("`{word}` names no reference point: P2, P3 or P4 go with G30.")),
        Message::NotAtReference { x, z } => {
            Sentence::new(format!("G27 does not end at the reference point, X{} Z{} here.", number(*x), number(*z)))
                .help("G27 checks that the tool stands there, and raises an alarm where it does not.")
        }
        Message::NoIntermediate => Sentence::new("G29 has no intermediate point: no G28 or G30 came before."),
        Message::MachineZero { x, z } => {
            Sentence::new(format!("G53 counts from the machine's own zero; here the reference point X{} Z{} is taken for it.", number(*x), number(*z)))
                .help("The machine knows where that is, the program does not. Set `refPoint` in the setup to where the slides stand at home.")
        }
        Message::OffsetNumber { word } => Sentence::new(format!("`{word}` names no entry of the offset table.")),
        Message::TipNumber { word } => Sentence::new(format!("`{word}` is no tip direction: 0 to 9.")),
        Message::DataPassedOver => Sentence::new("What follows up to G11 is data for the control's tables; it is passed over."),
        Message::HoleInForce { word, hole, .. } => Sentence::new(format!("`{word}` may not stand while {hole} is in force."))
            .help("Write G80 before it: until then every X, Z or C makes another hole."),
        Message::PeckZero { word } => Sentence::new(format!("`{word}` is no depth of a peck."))
            .help("Q is the depth of each peck in micrometres, as in Q5000. Without Q the hole is drilled in one cut."),
        Message::HoleNoDepth { code } => Sentence::new(format!("{code} has no depth."))
            .help("G83 G84 G85 need Z or W, G87 G88 G89 need X or U for the bottom of the hole."),
        Message::HoleOfOthers { code } => Sentence::new(format!("{code} is not in FANUC's system A; it is drawn as on lathes that have it."))
            .help("It drills along Z from the start point and back. FANUC turning controls drill with G83, or with G74."),
        Message::MakerG { word } => Sentence::new(format!("`{word}` depends on the machine; it is passed over."))
            .help("Makers use such numbers for codes of their own. What it does is not drawn."),
        Message::UnknownG { word } => Sentence::new(format!("`{word}` is not a G code of this control."))
            .help("The whole block is not carried out. Check the number."),
        Message::UnknownM { word } => Sentence::new(format!("`{word}` is known only to some machines; it is passed over."))
            .help("The machine's own manual says what it does."),
        Message::NotSupported { what } => Sentence::new(format!("{what} is not supported here."))
            .help("This is no fault of the program. Motions after it may be wrong and are drawn faint."),
        Message::PointNotAllowed { word } => Sentence::new(format!("`{word}` must be a whole number, without a point.")),
        Message::MinusNotAllowed { word } => Sentence::new(format!("`{word}` cannot be negative.")),
        Message::DuplicateWord { address, used } => {
            Sentence::new(format!("{address} stands twice in this block; `{used}` counts."))
                .help("The control takes the later one, or stops with an alarm. Delete the wrong one.")
        }
        Message::SameGroup { dropped, used } => {
            Sentence::new(format!("`{dropped}` and `{used}` exclude each other; `{used}` counts."))
                .help("Both belong to one modal group. In a block the last of a group is valid.")
        }
        Message::AbsoluteAndIncremental { absolute, incremental, used } => {
            Sentence::new(format!("`{absolute}` and `{incremental}` name the same axis; `{used}` counts."))
                .help("Controls differ here: FANUC takes the later word, GSK the absolute one.")
        }
        Message::ToolWithSetting { word } => {
            Sentence::new(format!("`{word}` may not stand in one block with G50, G10 or G04."))
                .help("Call the tool in a block of its own.")
        }
        Message::ShortTool { word, offset } => {
            Sentence::new(format!("`{word}` has no station number: it selects offset {offset} and leaves the turret where it is."))
                .help("On a four-digit control write station and offset, such as T0101.")
        }
        Message::ToolNumber { word } => {
            Sentence::new(format!("`{word}` is not a tool number.")).help("Write station and offset, such as T0101.")
        }
        Message::G90AsAbsolute => Sentence::new("G90 on a lathe is the turning cycle, not absolute programming.")
            .help("X and Z are always absolute here, U and W incremental. As it stands, the next X or Z would start a cycle: delete G90."),
        Message::LetterIInG92 { as_taper } => {
            let reading = if *as_taper { "the taper, as R" } else { "threads per inch" };
            Sentence::new(format!("I in G92 was read as {reading}."))
                .help("FANUC reads I as the taper (the old spelling of R), GSK as threads per inch.")
        }
        Message::G28NoAxis => {
            Sentence::new("G28 names no axis, so nothing moves.").help("Write G28 U0 W0 to send both axes home.")
        }
        Message::DwellNoTime => {
            Sentence::new("G04 has no time, so it does not wait.").help("Write X or U in seconds, or P in milliseconds.")
        }
        Message::AxisNotHere { word } => Sentence::new(format!("The Y axis of `{word}` is not supported here: only X, Z and C are drawn."))
            .help("The moves of X and Z are drawn all the same, faint from here on. Said once."),
        Message::PlaneNotHere { word } => Sentence::new(format!("Arcs in the plane of {word} are not supported here outside G12.1."))
            .help("Turning needs G18. Milling arcs on the end face are written under G12.1. Said once."),
        Message::CAxisNotConnected => Sentence::new("C moves here, but nothing before has connected the C axis.")
            .help("Which code does depends on the machine: M45 and G28 H0 on some. Under spindle control C raises an alarm."),
        Message::LiveToolStopped => Sentence::new("A live tool cuts here, but nothing before has started it.")
            .help("Which code does depends on the machine: M13 or M14 with S on some."),
        Message::PolarForbidden { word } => Sentence::new(format!("`{word}` is not allowed between G12.1 and G13.1."))
            .help("There only G01 G02 G03 G04 G40 G41 G42 G65 G66 G67 G98 G99 may stand: approach with G01, or leave by G13.1 first."),
        Message::PolarFrame { word } => Sentence::new(format!("`{word}` changes coordinates between G12.1 and G13.1."))
            .help("Set the zero point before G12.1: X0 must be the centre of the spindle."),
        Message::PolarNotAlone { code, other } => {
            Sentence::new(format!("{code} must stand alone in its block, without `{other}`.")).help("Move the other words to a block of their own.")
        }
        Message::PlaneCompensation { code } => Sentence::new(format!("{code} stands under G41 or G42."))
            .help("Compensation begins and ends inside: behind G12.1 or G07.1 C…, and by G40 before G13.1 or G07.1 C0."),
        Message::PolarFeedPerTurn => Sentence::new("Feed per turn (G99) makes no sense in polar interpolation.")
            .help("The spindle only positions there: write G98 and F in mm per minute."),
        Message::PolarNoRadius => Sentence::new("G41 or G42 has no cutter radius here, so nothing is compensated.")
            .help("Give the offset of the tool a radius; then the cutter's centre keeps that distance from the path."),
        Message::PolarAngle { word } => Sentence::new(format!("`{word}` looks like degrees; between G12.1 and G13.1 C is a length in mm."))
            .help("The path is written in a plane: X as a diameter to the right, C in mm upwards."),
        Message::PolarCenter { distance } => {
            Sentence::new(format!("The path comes within {} mm of the spindle axis, where C would have to turn without bound.", number(*distance)))
                .help("A control slows down there or stops with an alarm. Keep away from the centre.")
        }
        Message::PlaneLeftOn { code, off } => Sentence::new(format!("Interpolation with C is still on at `{code}`."))
            .help(format!("Write {off} in a block of its own before.")),
        Message::CylinderFormat => Sentence::new("G07.1 needs C with the radius of the cylinder, and nothing else.")
            .help("G07.1 C30 begins with a radius of 30 mm, G07.1 C0 ends it. It may not be begun twice."),
        Message::CylinderForbidden { word } => Sentence::new(format!("`{word}` is not allowed in cylindrical interpolation."))
            .help("There only G01 to G04 and G40 to G42 may stand, arcs are given by R, and rapids come before G07.1 or behind G07.1 C0."),
Message::DwellWithPoint { word } => Sentence::new(format!("`{word}` has a point; it was read as seconds."))
            .help("FANUC takes milliseconds without a point and raises an alarm here; Haas reads seconds. X or U give seconds everywhere."),
                Message::FeedMissing => Sentence::new("There is no feed: no F other than zero has been given before this cut.")
            .help("Fresh from power-on a control stops here; otherwise it cuts with the F of the program before. Add an F word, such as F0.2 under G99 (mm per turn) or F200 under G98 (mm per minute)."),
        Message::LeadMissing { code } => Sentence::new(format!("{code} has no lead."))
            .help("F gives the lead of the thread in mm."),
        Message::FeedUnit { feed, per_turn: true } => {
            let feed = number(*feed);
            Sentence::new(format!("F{feed} under G99 is {feed} mm per turn of the spindle."))
                .help("That is far too much for a cut. Was G98 (mm per minute) meant? Set the control's feed mode, or write G98.")
        }
        Message::FeedUnit { feed, per_turn: false } => {
            let feed = number(*feed);
            Sentence::new(format!("F{feed} under G98 is only {feed} mm per minute."))
                .help("Was G99 (mm per turn) meant? Set the control's feed mode, or write G99.")
        }
        Message::FeedNotRepeated { feed, per_turn } => {
            let (code, unit) = if *per_turn { ("G99", "mm per turn") } else { ("G98", "mm per minute") };
            Sentence::new(format!("After {code} the old F{} now counts as {unit}.", number(*feed)))
                .help("Write F anew whenever the feed mode changes.")
        }
        Message::SpindleStopped => Sentence::new("The tool cuts while the spindle stands still.")
            .help("Start the spindle with M03 or M04 before the first cut."),
        Message::NoSpeedClamp => Sentence::new("G96 without a highest spindle speed.")
            .help("Towards the centre the speed rises without bound. Give a limit first, such as G50 S2000."),
        Message::ClampReversed { lowest, highest } => Sentence::new(format!(
            "The lowest spindle speed Q{} is above the highest S{}.",
            number(*lowest),
            number(*highest)
        )),
        Message::ThreadAtSurfaceSpeed { code } => {
            Sentence::new(format!("{code} cuts a thread under G96, where the spindle speed changes with X."))
                .help("Every pass must meet the same groove: give a constant speed with G97 S….")
        }
        Message::ArcNoCenter { code } => Sentence::new(format!("{code} has neither R nor I, K."))
            .help("Give the radius with R, or the centre from the start point with I and K; or was G01 meant? FANUC goes straight there unless a parameter asks for the alarm."),
        Message::ArcRadiusTooSmall { radius, distance } => Sentence::new(format!(
            "R{} is too small: start and end of the arc are {} mm apart.",
            number(*radius),
            number(*distance)
        ))
        .help(format!("The radius must be at least {} mm, half the distance. X counts as a diameter.", number(distance / 2.0))),
        Message::ArcEndOffCircle { start_radius, end_radius } => Sentence::new(format!(
            "The end point is not on the circle: the centre is {} mm from the start but {} mm from the end.",
            number(*start_radius),
            number(*end_radius)
        ))
        .help("I is a radius value from the start point to the centre, K the same along Z; both have a sign."),
        Message::ArcRadiusNegative { radius } => Sentence::new(format!("This control does not take R{}.", number(*radius)))
            .help("Give arcs of more than 180° with I and K."),
        Message::ArcNowhere => Sentence::new("The arc ends where it begins, so with R nothing moves.")
            .help("A full circle is written with I and K."),
        Message::TaperBeyondStart { taper, limit, axis } => Sentence::new(format!(
            "`R{}` is larger than {} of `{axis}{}`: the cut would begin outside the start point.",
            number(*taper),
            if *axis == 'U' { "half" } else { "the length" },
            number(*limit)
        ))
        .help("When R and the way to the end point have different signs, the start of the cut must not lie beyond the start point."),
        Message::TaperNotExtended { taper, needed, crossing, wanted, axis } => Sentence::new(format!(
            "R{} is the taper of the drawing, not of the real start point: the cut leaves the stock at {axis}{}, not {axis}{}.",
            number(*taper),
            number(*crossing),
            number(*wanted)
        ))
        .help(format!("The cut begins outside the stock, so R must be longer in proportion: R{}.", number(*needed))),
        Message::ContourNotNamed { code } => Sentence::new(format!("{code} needs both P and Q."))
            .help("P names the first block of the contour by its N number, Q the last."),
        Message::ContourNotFound { word } => Sentence::new(format!("No block has the number that `{word}` names."))
            .help("P names the first block of the contour, Q the last, which must stand behind it in the same program."),
        Message::ContourFirstBlock { code } => {
            Sentence::new(format!("The first block of the contour of {code} does not move by G00 or G01."))
                .help("It takes the tool from the start point to where the contour begins.")
        }
        Message::ContourIllegal { word } => Sentence::new(format!("`{word}` may not stand between P and Q."))
            .help("A contour holds moves by G00, G01, G02 and G03 only. The cycle is not carried out."),
        Message::ContourReachesOver { code, word, line } => {
            Sentence::new(format!("P and Q of {code} take in another operation: `{word}` in line {line}."))
                .help("Look at the sequence numbers: one may stand twice, or Q may name a block far behind. The cycle is not carried out.")
        }
        Message::ContourCall { word } => Sentence::new(format!("`{word}` calls a subprogram inside a contour."))
            .help("Write the moves out between P and Q. The cycle is not carried out."),
        Message::ContourBothAxes { code, other } => {
            Sentence::new(format!("The first block of the contour of {code} names {other} too, though it does not move."))
                .help("Controls take two axes there as type II (pockets). Leave the word out for type I.")
        }
        Message::ContourTypeTwo { code } => {
            Sentence::new(format!("The first block of the contour of {code} moves both axes, which this control does not take."))
                .help("Without pockets (type II) only one axis may move there.")
        }
        Message::ContourTurnsBack { code, axis, line, .. } => {
            Sentence::new(format!("The contour of {code} turns back in {axis} at line {line}."))
                .help("Type I takes contours that go one way in both axes; type II, with two axes in the first block, allows pockets in depth.")
        }
        Message::ContourBeyondStart { code, axis } => {
            Sentence::new(format!("The contour of {code} goes beyond the start point in {axis}."))
                .help("Start the cycle outside the contour.")
        }
        Message::ContourNothingToCut { code } => Sentence::new(format!("Between the start point and this contour there is nothing for {code} to cut."))
            .help("The contour needs a depth below the start point and a way along it: more than its first and last block."),
        Message::ContourOpenEnd { word, .. } => Sentence::new(format!("`{word}` in the last block of the contour has no next move."))
            .help("A contour cannot end in a chamfer, a rounded corner or an open angle."),
        Message::DepthNotPositive { code, depth: None } => Sentence::new(format!("{code} has no depth of cut."))
            .help("Give it in a first block, such as G71 U2 R0.5 or G72 W2 R0.5. U or W beside P and Q is the allowance."),
        Message::DepthNotPositive { code, depth: Some(depth) } => {
            Sentence::new(format!("The depth of cut {} of {code} must be larger than zero.", number(*depth)))
                .help("It has no sign: the cycle finds its direction from the contour. Digits below 0.001 mm do not count.")
        }
        Message::AllowanceSign { word } => Sentence::new(format!("The allowance `{word}` points into the part."))
            .help("Outside work has a positive U, bores a negative one; W points away from the direction of cut."),
        Message::PatternPasses { passes: None } => {
            Sentence::new("G73 has no number of passes.").help("Give it as R in a first block, such as G73 U9 W2 R5.")
        }
        Message::PatternPasses { passes: Some(passes) } => {
            Sentence::new(format!("G73 cannot make {} passes.", number(*passes)))
        }
        Message::TooManyPasses { code, most } => {
            Sentence::new(format!("{code} would make more than {most} moves; it is not carried out."))
                .help("Is the depth, the peck or the first cut far too small? Amounts without a point may be micrometres.")
        }
        Message::PeckNegative { word } => Sentence::new(format!("`{word}` cannot be negative."))
            .help("Pecks and steps have no sign: the direction follows from the end point."),
        Message::PeckMissing { code, address } => {
            Sentence::new(format!("{code} moves this axis but has no {address}."))
                .help("P is the amount along X (radius), Q along Z.")
        }
        Message::ReliefNegative { word } => Sentence::new(format!("The relief `{word}` cannot be negative here."))
            .help("Its direction follows from the steps."),
        Message::AmountInMillimetres { word } => Sentence::new(format!("`{word}` was read as mm (inches under G20)."))
            .help("FANUC and GSK controls count P and Q in micrometres, without a point: 5 mm is 5000. Set pqUnit to decide."),
        Message::ThreadAngle { angle } => Sentence::new(format!("{}° is no tool angle of G76.", number(*angle)))
            .help("FANUC takes 80, 60, 55, 30, 29 and 0 degrees: the last two digits of P."),
        Message::ThreadLeastDepth { least, height } => Sentence::new(format!(
            "The least depth {} mm is larger than the thread height {} mm.",
            number(*least),
            number(*height)
        ))
        .help("Q of the first block and P of the second are micrometres."),
        Message::ThreadNoDepth { word } => {
            let what = if *word == 'P' { "thread height P" } else { "first depth Q" };
            Sentence::new(format!("G76 needs a {what} larger than zero."))
                .help("P is the height of the thread, Q the depth of the first cut, both as radius values in micrometres.")
        }
        Message::ThreadStartInside { start, crest } => Sentence::new(format!(
            "G76 starts at X{}, inside the crest of the thread at X{}.",
            number(*start),
            number(*crest)
        ))
        .help("The tool returns to the start X after every pass: it must clear the work."),
        Message::CornerNoMove { word } => Sentence::new(format!("`{word}` has no straight move behind it to form a corner with."))
            .help("The next block must move by G01 (G02 and G03 for `,C` and `,R`)."),
        Message::CornerTooLarge { word } => Sentence::new(format!("`{word}` is larger than the moves beside it.")),
        Message::CornerNone { word } => Sentence::new(format!("`{word}`: these two moves form no corner."))
            .help("The path goes straight on or turns back on itself."),
        Message::CornerAxis { word, .. } => Sentence::new(format!("`{word}` does not fit the next move."))
            .help("Without a comma, a chamfer or radius joins a move along one axis to a move along the other; its sign is the direction of the next move."),
        Message::CornerTwice { word, other } => {
            Sentence::new(format!("`{word}` and `{other}` both ask for a corner; a block can have one."))
        }
        Message::CornerInThread { word } => Sentence::new(format!("`{word}`: a thread cannot end in a chamfer or a rounded corner."))
            .help("Put the corner into a block with G01."),
        Message::CornerWithCompensation { word } => {
            Sentence::new(format!("`{word}` stands where compensation begins or ends."))
                .help("Put G40, G41 and G42 into a block without a corner.")
        }
        Message::CycleWord { code, word } => Sentence::new(format!("`{word}` may not stand in a block with {code}."))
            .help("The end of the contour is in its blocks P to Q; the cycle takes P, Q, U, W and F, S, T."),
        Message::CycleAxis { code, word } => Sentence::new(format!("`{word}`: {code} moves only X and Z.")),
        Message::CyclePlane { code, .. } => Sentence::new(format!("{code} works only in the plane G18."))
            .help("Write G18 before it."),
        Message::FinishStart { roughed_x, roughed_z } => Sentence::new(format!(
            "G70 does not start where the contour was roughed from, X{} Z{}.",
            number(*roughed_x),
            number(*roughed_z)
        ))
        .help("The first and the last move are rapids: from another point they may cross the part."),
        Message::FinishWithoutRoughing { first, last } => {
            Sentence::new(format!("The contour N{first} to N{last} is finished by G70, but no G71, G72 or G73 roughs it."))
                .help("Is the blank near the finished size, or do P and Q name the wrong blocks?")
        }
        Message::AngleNoPoint { word, .. } => Sentence::new(format!("`{word}` leads to no point."))
            .help("Angles count from +Z, counter-clockwise. Two lines must cross; one line needs X or Z beside its angle."),
        Message::CompensationOnArc { code } => Sentence::new(format!("{code} may not begin or end on an arc."))
            .help("Put G40, G41 and G42 on a straight move (G00 or G01)."),
        Message::CompensationOvercut { radius, .. } => {
            Sentence::new(format!("A nose of R{} does not fit here: it would cut into the contour.", number(*radius)))
                .help("A step is lower, a groove narrower or an inner arc smaller than the nose.")
        }
        Message::CompensationNoIntersection { radius } => {
            Sentence::new(format!("With a nose of R{} these two moves do not meet.", number(*radius)))
        }
        Message::CompensationPlane => Sentence::new("The plane may not change while G41 or G42 is on.")
            .help("Write G40 first."),
        Message::LeadRunsOut { lead } => Sentence::new(format!("The lead of G34 would become {} mm.", number(*lead)))
            .help("K is the change of lead for each turn; it must leave the lead positive to the end."),
        Message::CompensationIdle { code } => {
            Sentence::new(format!("Nose radius compensation is on, but it changes nothing in this {code}."))
                .help("Threads are cut without it; G90 and G94 need a nose radius in the tool's offset.")
        }
    }
}

/// What is wrong with a macro.
fn macro_fault(kind: FaultKind) -> Sentence {
    match kind {
        FaultKind::Overflow => Sentence::new("This value is too large to be a number of a macro."),
        FaultKind::DivisionByZero => {
            Sentence::new("This divides by zero.").help("A vacant variable counts as 0.")
        }
        FaultKind::UnknownFunction => Sentence::new("There is no such function.").help(
            "SIN COS TAN ASIN ACOS ATAN SQRT ABS ROUND FIX FUP LN EXP POW MOD, with their values in `[ ]`.",
        ),
        FaultKind::Expression => Sentence::new("This expression cannot be read.")
            .help("Write `#1+2`, `[#1-#2]*3`, `SIN[#4]`: square brackets, a sign between any two values."),
        FaultKind::BracketOpen => Sentence::new("This `[` has no `]`."),
        FaultKind::NumberOrCondition => {
            Sentence::new("A condition stands where a number belongs, or a number where a condition belongs.")
                .help("A condition compares: `[#1 GT 10]`, with EQ NE GT GE LT LE.")
        }
        FaultKind::VariableNumber => Sentence::new("There is no such variable.")
            .help("Local #1 to #33, common #100 to #199 and #500 to #999, system variables from #1000 on."),
        FaultKind::ReadOnly => Sentence::new("This variable can only be read, not written."),
        FaultKind::BracketsTooDeep => Sentence::new("More than five brackets stand inside each other."),
        FaultKind::FunctionArgument => Sentence::new("The function has no result for this value.")
            .help("Such as the root or the logarithm of a negative number."),
        FaultKind::CallsTooDeep => Sentence::new("Too many macro calls stand inside each other."),
        FaultKind::EndMissing => Sentence::new("This DO has no END of the same number."),
        FaultKind::Format => Sentence::new("This macro statement cannot be read.").help(
            "Such as `#1=#2+1`, `IF[#1 GT 5]GOTO 10`, `IF[#1 EQ 0]THEN #2=1`, `WHILE[#1 LE 9]DO1` … `END1`.",
        ),
        FaultKind::LoopNumber => {
            Sentence::new("The number of a loop is 1, 2 or 3, and END belongs to a DO that runs.")
        }
        FaultKind::WordsBehind => Sentence::new("A macro statement must have its block to itself.")
            .help("Put the words of the machine in a block of their own."),
        FaultKind::JumpTarget => Sentence::new("GOTO needs a sequence number from 1 to 99999."),
        FaultKind::ArgumentLetter => Sentence::new("This letter cannot hand an argument to a macro.")
            .help("G, L, N, O and P cannot be used."),
    }
}

pub(super) fn fix_title(message: &Message) -> String {
    match message {
        Message::CommentOpen => "Close the comment".into(),
        Message::CommaForPoint { .. } => "Write a decimal point".into(),
        Message::LetterForDigit { digit, .. } => format!("Write the digit {digit}"),
        Message::ZeroForO { .. } => "Write the letter O".into(),
        Message::PrintedMinus => "Write a minus".into(),
        other => sentence(other).message,
    }
}

pub(super) fn motion(motion: &Motion, passes: Option<u32>) -> String {
    let kind = match motion.kind {
        MotionKind::Rapid => "rapid",
        MotionKind::Feed => "feed",
        MotionKind::ArcClockwise => "arc G02",
        MotionKind::ArcCounterclockwise => "arc G03",
        MotionKind::Thread => "thread",
        MotionKind::Dwell => "dwell",
    };
    let to = end_of(motion);
    if let Some(seconds) = motion.seconds {
        return format!("dwell {} s at {to}", number(seconds));
    }
    let Some(cycle) = motion.cycle else {
        return format!("{kind} to {to}");
    };
    let step = match cycle.step {
        Step::Infeed => "infeed",
        Step::Cut => "cut",
        Step::PullOut => "pull-out",
        Step::Retract => "retract",
        Step::Return => "return",
        Step::Approach => "approach",
        Step::Escape => "escape",
        Step::Contour => "along the contour",
        Step::Relief => "relief",
        Step::Stepover => "step-over",
    };
    let manner = match motion.kind {
        MotionKind::Rapid => "at rapid",
        MotionKind::Thread => "in step with the spindle",
        _ => "at feed",
    };
    let pass = match passes {
        Some(all) if cycle.pass > 0 => format!(", pass {} of {all}", cycle.pass),
        None if cycle.pass > 0 => format!(", pass {}", cycle.pass),
        _ => String::new(),
    };
    format!("{}{pass}: {step} {manner} to {to}", cycle.cycle.code())
}
