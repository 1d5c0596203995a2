//! Each rule of custom macro B, and each error beside the correct form.

use std::collections::BTreeMap;

use super::*;

#[cfg(not(target_arch = "wasm32"))]
mod properties;

/// The values of the variables.
#[derive(Default)]
struct Plain(BTreeMap<u32, f64>);

impl Memory for Plain {
    fn read(&mut self, variable: u32) -> Result<Option<f64>, MacroErrorKind> {
        Ok(self.0.get(&variable).copied())
    }

    fn write(&mut self, variable: u32, value: Option<f64>) -> Result<(), MacroErrorKind> {
        match value {
            Some(value) => self.0.insert(variable, value),
            None => self.0.remove(&variable),
        };
        Ok(())
    }
}

/// #1 is 2, #2 is 5, #3 is -1.5, #9 is vacant.
fn memory() -> Plain {
    Plain(BTreeMap::from([(1, 2.0), (2, 5.0), (3, -1.5), (102, 7.0)]))
}

/// The value that `#100=…` assigns.
fn assigned(expression: &str) -> Result<Option<f64>, MacroError> {
    let mut memory = memory();
    statement(format!("#100={expression}").as_bytes(), &mut memory)?;
    Ok(memory.0.get(&100).copied())
}

#[track_caller]
fn check(expression: &str, expected: f64) {
    match assigned(expression) {
        Ok(Some(value)) => {
            assert!((value - expected).abs() <= 1e-12 * expected.abs().max(1.0), "{expression}: {value}");
        }
        other => panic!("{expression}: {other:?}"),
    }
}

#[track_caller]
fn exact(expression: &str, expected: f64) {
    assert_eq!(assigned(expression), Ok(Some(expected)), "{expression}");
}

/// Checks the alarm and the text of its span.
#[track_caller]
fn refused(text: &str, alarm: &str, quote: &str) {
    let fault = statement(text.as_bytes(), &mut memory()).expect_err(text);
    assert_eq!(
        (fault.kind.message().alarm().unwrap_or_default(), &text[fault.at.clone()]),
        (alarm, quote),
        "{text}: {fault:?}"
    );
}

fn act(text: &str) -> Result<Action, MacroErrorKind> {
    statement(text.as_bytes(), &mut memory()).map_err(|fault| fault.kind)
}

fn address(text: &str) -> Result<Option<f64>, MacroErrorKind> {
    address_value(text.as_bytes(), 0.001, &mut memory()).map_err(|fault| fault.kind)
}

fn holds(condition: &str) -> Result<bool, MacroErrorKind> {
    act(&format!("IF{condition}GOTO1")).map(|action| action == Action::Goto(1))
}

#[test]
fn functions_come_before_products_and_products_before_sums() {
    exact("1+2*3", 7.0);
    exact("2*3+4/2", 8.0);
    exact("10-4-3", 3.0);
    exact("24/4/3", 2.0);
    exact("1+SQRT[9]*2", 7.0);
    exact("[1+2]*3", 9.0);
    // AND has the precedence of a product, OR and XOR that of a sum.
    exact("1+6AND3", 3.0);
    exact("1OR6AND3", 3.0);
    exact("12OR3XOR5", 10.0);
    exact("7MOD4+1", 4.0);
}

#[test]
fn numbers_and_signs_may_be_written_in_many_ways() {
    exact(".5+5.", 5.5);
    exact("-#3", 1.5);
    exact("--2", 2.0);
    exact("3*-2", -6.0);
    exact("+#1", 2.0);
    exact("-[#1+1]", -3.0);
    exact(" 1 ( one ) + ( (two) ) 2 (three)", 3.0);
    exact("#[#1+100]", 7.0);
    exact("#[ 101 + [2/2] ]", 7.0);
    exact("sin[30]+Sqrt[4]", 2.5);
    check("1234567.12345678", 1234567.12345678);
    check("123456789012345678901234567890", 123456789012345678901234567890.0);
}

#[test]
fn functions_count_in_degrees_and_are_exact_where_they_can_be() {
    for (expression, value) in [
        ("SIN[180]", 0.0),
        ("SIN[30]", 0.5),
        ("SIN[-90]", -1.0),
        ("SIN[720+150]", 0.5),
        ("COS[90]", 0.0),
        ("COS[60]", 0.5),
        ("COS[360000]", 1.0),
        ("TAN[45]", 1.0),
        ("TAN[135]", -1.0),
        ("TAN[180]", 0.0),
        ("ASIN[0.5]", 30.0),
        ("ASIN[-0.5]", 330.0),
        ("ACOS[-1]", 180.0),
        ("ACOS[0.5]", 60.0),
        ("ATAN[1]/[1]", 45.0),
        ("ATAN[1]/[-1]", 135.0),
        ("ATAN[-1]/[-1]", 225.0),
        ("ATAN[-1] / [0]", 270.0),
        ("ATAN[-1,1]", 315.0),
        ("ATAN[1]", 45.0),
        ("ATAN[1]/9", 5.0),
        ("SQRT[16]", 4.0),
        ("ABS[#3]", 1.5),
        ("ROUND[2.5]", 3.0),
        ("ROUND[-2.5]", -3.0),
        ("FIX[1.9]", 1.0),
        ("FIX[-1.9]", -1.0),
        ("FIX[0.29*100]", 29.0),
        ("FUP[1.2]", 2.0),
        ("FUP[-1.2]", -2.0),
        ("FUP[3]", 3.0),
        ("LN[1]", 0.0),
        ("EXP[0]", 1.0),
        ("POW[2,10]", 1024.0),
        ("POW[-2,3]", -8.0),
        ("BCD[15]", 21.0),
        ("BIN[21]", 15.0),
        ("ADP[#1]", 2.0),
    ] {
        exact(expression, value);
    }
    check("SIN[20]", 20f64.to_radians().sin());
    check("COS[-250]", (-250f64).to_radians().cos());
    check("TAN[20]", 20f64.to_radians().tan());
    check("LN[EXP[2.5]]", 2.5);
}

#[test]
fn a_function_may_be_shortened_to_two_letters() {
    for (short, long) in [
        ("SI[10]", "SIN[10]"),
        ("CO[10]", "COS[10]"),
        ("TA[10]", "TAN[10]"),
        ("AS[.3]", "ASIN[.3]"),
        ("AC[.3]", "ACOS[.3]"),
        ("AT[3]/[4]", "ATAN[3]/[4]"),
        ("SQR[7]", "SQRT[7]"),
        ("SQ[7]", "SQRT[7]"),
        ("AB[-7]", "ABS[-7]"),
        ("RO[7.6]", "ROUND[7.6]"),
        ("RND[7.6]", "ROUND[7.6]"),
        ("FI[7.6]", "FIX[7.6]"),
        ("FU[7.1]", "FUP[7.1]"),
        ("EX[2]", "EXP[2]"),
        ("BI[16]", "BIN[16]"),
        ("BC[10]", "BCD[10]"),
        ("AD[10]", "ADP[10]"),
    ] {
        assert_eq!(assigned(short), assigned(long), "{short}");
        assert!(assigned(short).is_ok(), "{short}");
    }
}

#[test]
fn remainders_are_of_whole_numbers_and_keep_the_sign_of_the_first() {
    exact("7MOD3", 1.0);
    exact("-7 MOD 3", -1.0);
    exact("7MOD-3", 1.0);
    exact("7.4MOD2.6", 1.0);
}

#[test]
fn a_vacant_variable_is_zero_in_arithmetic_and_stays_vacant_when_copied() {
    assert_eq!(assigned("#9"), Ok(None));
    assert_eq!(assigned("#0"), Ok(None));
    exact("#9+1", 1.0);
    exact("#9*#2", 0.0);
    exact("-#9", 0.0);
    exact("ABS[#9]", 0.0);
}

#[test]
fn a_vacant_variable_differs_from_zero_for_eq_and_ne_only() {
    for (condition, truth) in [
        ("[#9 EQ #0]", true),
        ("[#9 EQ 0]", false),
        ("[#9 NE 0]", true),
        ("[#9 NE #0]", false),
        ("[#9 GE 0]", true),
        ("[#9 GT 0]", false),
        ("[#9 LE 0]", true),
        ("[#9 LT 0]", false),
        ("[#9+0 EQ 0]", true),
    ] {
        assert_eq!(holds(condition), Ok(truth), "{condition}");
    }
}

#[test]
fn conditions_may_be_joined() {
    for (condition, truth) in [
        ("[#1EQ2]", true),
        ("[#1NE2]", false),
        ("[#1 GT SIN[30]]", true),
        ("[#1LT#2]", true),
        ("[#2 le 5]", true),
        ("[1 EQROUND[1.2]]", true),
        ("[[#1 EQ 2] AND [#2 EQ 4]]", false),
        ("[[#1 EQ 2] OR [#2 EQ 4]]", true),
        ("[[#1 EQ 2] XOR [#2 EQ 5]]", false),
        ("[#1 EQ 2 AND #2 EQ 5]", true),
        ("[#1 EQ 3 AND #2 EQ 5 OR 1 LT 2]", true),
        ("[1 LT 2 OR #1 EQ 3 AND #2 EQ 4]", true),
        ("[[[#1 EQ 2] OR [#1 EQ 3]] AND [#2 GT 1]]", true),
        ("[#1 EQ 2]AND[#2 EQ 5]", true),
        // For numbers, AND works bit by bit.
        ("[#2 AND 4 EQ 4]", true),
        ("[#1 EQ 6 AND 3]", true),
        ("[#1 EQ 6 AND 3 AND #2 EQ 5]", true),
        ("[4 EQ #2 AND [1+3]]", true),
        ("[#1 EQ 2 AND [#2 EQ 5]]", true),
    ] {
        assert_eq!(holds(condition), Ok(truth), "{condition}");
    }
    refused("IF[#1]GOTO1", "PS0114", "[#1]");
    refused("IF[#1 LT #2 LT 3]GOTO1", "PS0114", "L");
    refused("IF[[#1 EQ 2] AND 5]GOTO1", "PS0114", "5");
    refused("#1=[#2 EQ 5]+1", "PS0114", "[#2 EQ 5]");
    refused("#1=#2 EQ 5", "PS0114", "E");
    refused("IF #1 EQ 2 GOTO 1", "PS0125", "#");
}

#[test]
fn five_brackets_may_stand_inside_each_other() {
    exact("[[[[[1]]]]]", 1.0);
    exact("SIN[[[[#1+28]*#1+0]]]/1+#[1]", assigned("SIN[60]+2").unwrap().unwrap());
    refused("#1=[[[[[[1]]]]]]", "PS0118", "[");
    refused("#1=[[1]", "PS0114", "[");
    refused("#1=[1]]", "PS0114", "]");
    refused("#1=[]", "PS0114", "]");
    assert_eq!(act("#1=[[1]"), Err(MacroErrorKind::BracketOpen));
}

#[test]
fn what_has_no_result_is_refused() {
    refused("#1=2+4/[#2-5]+1", "PS0112", "[#2-5]");
    refused("#1=4MOD0.2", "PS0112", "0.2");
    refused("#1=EXP[200]", "PS0111", "EXP[200]");
    refused("#1=3*POW[10,46]*100", "PS0111", "3*POW[10,46]*100");
    refused("#1=1+SQRT[-1]", "PS0119", "SQRT[-1]");
    refused("#1=ASIN[1.1]", "PS0119", "ASIN[1.1]");
    refused("#1=ACOS[-1.1]", "PS0119", "ACOS[-1.1]");
    refused("#1=LN[0]", "PS0119", "LN[0]");
    refused("#1=TAN[90]", "PS0119", "TAN[90]");
    refused("#1=ATAN[0]/[0]", "PS0119", "ATAN[0]/[0]");
    refused("#1=POW[-2,0.5]", "PS0119", "POW[-2,0.5]");
    refused("#1=POW[0,-1]", "PS0119", "POW[0,-1]");
    refused("#1=POW[2]", "PS0119", "POW[2]");
    refused("#1=BIN[10]", "PS0119", "BIN[10]");
    refused("#1=BCD[-1]", "PS0119", "BCD[-1]");
    refused("#1=FOO[1]", "PS0113", "FOO");
    refused("#1=SIN 30", "PS0114", "3");
    refused("#1=SIN[1,2]", "PS0114", ",");
    refused("#1=", "PS0114", "=");
    refused("#1=1..2", "PS0114", "1");
    refused("#1=##2", "PS0114", "#");
    refused("#1=#-2", "PS0114", "-");
    refused("#1=#[-1]", "PS0115", "#[-1]");
    refused("#1=#[1.5]", "PS0115", "#[1.5]");
    // Values smaller than a control can store are zero, and rounding is no error.
    exact("POW[10,-20]*POW[10,-20]", 0.0);
    exact("SQRT[0.1+0.2-0.3-0.0000000000000001]", 0.0);
}

#[test]
fn an_address_takes_a_number_a_variable_or_brackets() {
    assert_eq!(address("#1"), Ok(Some(2.0)));
    assert_eq!(address("-#1"), Ok(Some(-2.0)));
    assert_eq!(address(" - - #[ 1 ] (in)"), Ok(Some(2.0)));
    assert_eq!(address("[#1+#2]"), Ok(Some(7.0)));
    assert_eq!(address("-[#1+#2]"), Ok(Some(-7.0)));
    assert_eq!(address("--5"), Ok(Some(5.0)));
    assert_eq!(address("+.5"), Ok(Some(0.5)));
    assert_eq!(address("#9"), Ok(None));
    assert_eq!(address("-#9"), Ok(None));
    assert_eq!(address("[#9+0]"), Ok(Some(0.0)));
    assert_eq!(address("#1+#2"), Err(MacroErrorKind::Expression));
    assert_eq!(address("[#1 EQ 2]"), Err(MacroErrorKind::NumberOrCondition));
    assert_eq!(address(""), Err(MacroErrorKind::Expression));
    assert_eq!(address_value(b"", 1.0, &mut memory()).unwrap_err().at, 0..0);
}

#[test]
fn round_in_an_address_keeps_the_least_increment() {
    assert_eq!(address("ROUND[1.23456]"), Ok(Some(1.235)));
    assert_eq!(address("-ROUND[1.23456]"), Ok(Some(-1.235)));
    assert_eq!(address("[ROUND[1.2345]+ROUND[2.3456]]"), Ok(Some(1.235 + 2.346)));
    // The number of a variable is always a whole number.
    assert_eq!(address("#[ROUND[1.6]]"), Ok(Some(5.0)));
    assert_eq!(address("[#[ROUND[1.6]]+ROUND[.0006]]"), Ok(Some(5.001)));
    let inch = address_value(b"ROUND[1.23456]", 0.0001, &mut memory());
    assert_eq!(inch, Ok(Some(1.2346)));
    let odd = address_value(b"ROUND[1.6]", f64::NAN, &mut memory());
    assert_eq!(odd, Ok(Some(2.0)));
}

#[test]
fn a_variable_gets_a_value() {
    let mut memory = memory();
    for text in ["#10=#1+1", "#[10+1]=4(four)", " (note) #12 = -1", "#1=#9", "IF[#2 EQ 5]#13=6"] {
        assert_eq!(statement(text.as_bytes(), &mut memory), Ok(Action::Done), "{text}");
    }
    assert_eq!(memory.0.get(&10), Some(&3.0));
    assert_eq!(memory.0.get(&11), Some(&4.0));
    assert_eq!(memory.0.get(&12), Some(&-1.0));
    assert_eq!(memory.0.get(&13), Some(&6.0));
    assert_eq!(memory.0.get(&1), None);
}

#[test]
fn a_block_holds_one_statement() {
    refused("#1=2 #3=4", "PS0125", "#");
    refused("#1=2 G01 X5", "PS0127", "G");
    refused("GOTO 5 X1", "PS0127", "X");
    refused("DO1 #1=2", "PS0125", "#");
    refused("#1=2 3", "PS0114", "3");
    refused("#1=2*", "PS0114", "*");
    refused("#1", "PS0125", "1");
    refused("#1 5", "PS0125", "5");
    refused("#1=5é", "PS0125", "é");
    refused("é", "PS0125", "é");
    refused("(é)", "PS0125", ")");
    let mut memory = memory();
    assert!(statement(b"#1=4 X2", &mut memory).is_err());
    assert_eq!(memory.0.get(&1), Some(&2.0), "a block that is wrong does nothing");
}

#[test]
fn jumps_name_a_block() {
    for text in
        ["GOTO10", "goto 10", "GOTO[#2*2]", "IF[1EQ1]GOTO#10", "IF[1EQ1]THEN GOTO 10", "GOTO ROUND[9.6]"]
    {
        let mut memory = memory();
        memory.0.insert(10, 10.0);
        assert_eq!(statement(text.as_bytes(), &mut memory), Ok(Action::Goto(10)), "{text}");
    }
    assert_eq!(act("IF[1EQ2]GOTO 10"), Ok(Action::Done));
    assert_eq!(act("IF[1EQ2]GOTO#3"), Ok(Action::Done));
    refused("GOTO#3", "PS0128", "#3");
    refused("GOTO 0", "PS0128", "0");
    refused("GOTO 2.5", "PS0128", "2.5");
    refused("GOTO 100000000", "PS0128", "100000000");
    refused("GOTO", "PS0114", "O");
}

#[test]
fn then_carries_out_a_statement_or_words() {
    let text = "IF [#1 EQ 2] THEN G01 X#1 (in)  ";
    let Ok(Action::Words(words)) = act(text) else { panic!() };
    assert_eq!(&text[words], "G01 X#1 (in)");
    assert_eq!(act("IF [#1 EQ 3] THEN G01 X#1"), Ok(Action::Done));
    assert_eq!(act("IF [#1 EQ 3] THEN #5=1"), Ok(Action::Done));
    refused("IF[#1 EQ 2]G01 X5", "PS0125", "G");
    refused("IF[#1 EQ 3]G01 X5", "PS0125", "G");
    refused("IF[#1 EQ 2]", "PS0125", "]");
    refused("IF[#1 EQ 2]THEN", "PS0125", "N");
    refused("IF[#1 EQ 2]THEN IF[#1 EQ 2]GOTO 5", "PS0125", "IF");
    refused("IF[#1 EQ 2]THEN WHILE[#1 EQ 2]DO1", "PS0125", "WHILE");
    refused("THEN #1=2", "PS0125", "T");
}

#[test]
fn loops_are_numbered_1_to_3() {
    assert_eq!(act("WHILE[#1LT5]DO1"), Ok(Action::While { number: 1, enter: true }));
    assert_eq!(act("WHILE [#1 GT 5] DO 2 (x)"), Ok(Action::While { number: 2, enter: false }));
    assert_eq!(act("DO3"), Ok(Action::Do { number: 3 }));
    assert_eq!(act("END 1"), Ok(Action::End { number: 1 }));
    refused("DO4", "PS0126", "4");
    refused("DO0", "PS0126", "0");
    refused("DO", "PS0126", "O");
    refused("DO#1", "PS0126", "#");
    refused("WHILE[1EQ1]DO12", "PS0126", "12");
    refused("ENDIF", "PS0126", "I");
    refused("WHILE[1EQ1]", "PS0125", "]");
    refused("WHILE[1EQ1]GOTO 5", "PS0125", "G");
}

#[test]
fn alarms_and_stops_carry_a_message() {
    let text = "IF[#1 EQ 2]THEN #3000=12 (TOOL (2) WORN) (x)";
    let Ok(Action::Alarm { number: 12, message }) = act(text) else { panic!() };
    assert_eq!(&text[message], "TOOL (2) WORN");
    let text = "#[3000+6]=1(TURN";
    let Ok(Action::Pause { message }) = act(text) else { panic!() };
    assert_eq!(&text[message], "TURN");
    let Ok(Action::Alarm { number: 1, message }) = act("#3000=1") else { panic!() };
    assert!(message.is_empty());
    let Ok(Action::Pause { message }) = act("#3006=1(") else { panic!() };
    assert!(message.is_empty());
}

#[test]
fn printing_is_recognised() {
    for text in ["POPEN", "PCLOS", "DPRNT[X#1[44]]", "bprnt[A*#1[3]]", "SETVN 500[A,B]"] {
        assert_eq!(act(text), Ok(Action::Print), "{text}");
    }
}

#[test]
fn variables_exist_by_number() {
    let mut variables = Variables::default();
    for number in [1, 33, 100, 199, 200, 231, 500, 999] {
        assert_eq!(variables.read(number), Ok(Found::Value(None)));
        assert_eq!(variables.write(number, Some(f64::from(number))), Ok(Stored::Done));
        assert_eq!(variables.read(number), Ok(Found::Value(Some(f64::from(number)))));
        assert_eq!(variables.write(number, None), Ok(Stored::Done));
        assert_eq!(variables.read(number), Ok(Found::Value(None)));
    }
    for number in [34, 99, 232, 499] {
        assert_eq!(variables.read(number), Err(MacroErrorKind::VariableNumber));
        assert_eq!(variables.write(number, None), Err(MacroErrorKind::VariableNumber));
    }
    for number in [1000, 5001, u32::MAX] {
        assert_eq!(variables.read(number), Ok(Found::System));
        assert_eq!(variables.write(number, None), Ok(Stored::System));
    }
    assert_eq!(variables.read(0), Ok(Found::Value(None)));
    assert_eq!(variables.write(0, Some(1.0)), Err(MacroErrorKind::ReadOnly));
    for (text, alarm, at) in
        [("#0=1", "PS0116", 0..2), ("#3=#34", "PS0115", 3..6), ("#200=1", "PS0115", 0..4)]
    {
        let fault = statement(text.as_bytes(), &mut variables).unwrap_err();
        assert_eq!((fault.kind.message().alarm().unwrap_or_default(), fault.at), (alarm, at));
    }
}

#[test]
fn each_call_has_its_own_local_variables() {
    let mut variables = Variables::default();
    variables.write(1, Some(1.0)).unwrap();
    variables.write(100, Some(1.0)).unwrap();
    assert!(variables.push_level(arguments([(b'B', 5.0)].into_iter()).unwrap()));
    assert_eq!(variables.read(1), Ok(Found::Value(None)));
    assert_eq!(variables.read(2), Ok(Found::Value(Some(5.0))));
    variables.write(1, Some(2.0)).unwrap();
    variables.write(100, Some(2.0)).unwrap();
    assert_eq!(variables.level(), 1);
    variables.pop_level();
    variables.pop_level();
    assert_eq!(variables.level(), 0);
    assert_eq!(variables.read(1), Ok(Found::Value(Some(1.0))));
    assert_eq!(variables.read(2), Ok(Found::Value(None)));
    assert_eq!(variables.read(100), Ok(Found::Value(Some(2.0))));
    for _ in 1..MAX_LEVELS {
        assert!(variables.push_level([None; LOCALS]));
    }
    assert!(!variables.push_level([None; LOCALS]));
}

#[test]
fn a_clone_goes_its_own_way() {
    let first = Variables::default();
    let mut second = first.clone();
    assert_eq!(first, second);
    for number in [1, 150, 600] {
        second.write(number, Some(1.0)).unwrap();
        assert_ne!(first, second);
        assert_eq!(first.read(number), Ok(Found::Value(None)));
        second.write(number, None).unwrap();
        assert_eq!(first, second);
    }
}

/// The variables that are not vacant.
fn handed_over(words: &str) -> Result<Vec<(usize, f64)>, ArgumentError> {
    let words = words.split_whitespace().map(|word| (word.as_bytes()[0], word[1..].parse().unwrap()));
    let locals = arguments(words)?;
    Ok((1..).zip(locals).filter_map(|(number, value)| Some((number, value?))).collect())
}

#[test]
fn each_letter_has_its_variable() {
    let letters = "A1 B2 C3 I4 J5 K6 D7 E8 F9 H11 M13 Q17 R18 S19 T20 U21 V22 W23 X24 Y25 Z26";
    let found = handed_over(letters).unwrap();
    assert_eq!(found.len(), 21);
    assert!(found.iter().all(|&(number, value)| number as f64 == value), "{found:?}");
}

#[test]
fn i_j_and_k_may_come_in_sets() {
    assert_eq!(handed_over("I1 J2 K3 I4 J5 K6"), handed_over("I1 J2 K3 D4 E5 F6"));
    assert_eq!(handed_over("I1 I2 J3").unwrap(), [(4, 1.0), (7, 2.0), (8, 3.0)]);
    assert_eq!(handed_over("J1 X9 K2 K3").unwrap(), [(5, 1.0), (6, 2.0), (9, 3.0), (24, 9.0)]);
    // Out of order, the next set begins.
    assert_eq!(handed_over("K1 J2").unwrap(), [(6, 1.0), (8, 2.0)]);
    let ten = "I1 J1 K1 ".repeat(10);
    assert_eq!(handed_over(&ten).unwrap().len(), 30);
    let eleven = handed_over(&(ten + "I1")).unwrap_err();
    assert_eq!((eleven.index, eleven.kind.message().alarm().unwrap_or_default()), (30, "PS0129"));
    // If two words set one variable, the later wins.
    assert_eq!(handed_over("I1 I2 D3").unwrap(), [(4, 1.0), (7, 3.0)]);
    assert_eq!(handed_over("D3 I1 I2").unwrap(), [(4, 1.0), (7, 2.0)]);
}

#[test]
fn some_letters_hand_over_nothing() {
    for letter in ["G", "L", "N", "O", "P"] {
        let fault = handed_over(&format!("A1 {letter}1")).unwrap_err();
        assert_eq!((fault.index, fault.kind), (1, MacroErrorKind::ArgumentLetter));
    }
}
