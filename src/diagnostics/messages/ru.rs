//! The messages in Russian.
//!
//! Counts stand where no plural form depends on them: "Не показано сообщений: 3."

use super::{Sentence, end_of, number};
use crate::control::macros::FaultKind;
use crate::control::origin::Origin;
use crate::diagnostics::message::Message;
use crate::motion::{Motion, MotionKind, Step};

pub(super) fn sentence(message: &Message) -> Sentence {
    match message {
        Message::NumberMissing { address } => Sentence::new(format!("У адреса `{address}` нет числа."))
            .help("После каждого адреса должно стоять число. Комментарий пишут в скобках: `( … )`."),
        Message::AddressMissing { number } => Sentence::new(format!("У числа `{number}` нет адреса."))
            .help("Поставьте перед числом нужный адрес, например X, Z или F."),
        Message::NotUnderstood { text } => Sentence::new(format!("`{text}` не относится ни к одному слову."))
            .help("Возможно, символ прочитан неверно или потерян. Комментарий пишут в скобках: `( … )`."),
        Message::PlainText { text } => Sentence::new(format!("`{text}` — обычный текст, а не кадр."))
            .help("Здесь стойка остановится с ошибкой. Пояснения пишут в скобках: `( … )`."),
        Message::SecondPoint { word } => Sentence::new(format!("В `{word}` две десятичные точки."))
            .help("Проверьте число и удалите лишнюю точку."),
        Message::TooManyDigits { word } => Sentence::new(format!("В `{word}` больше 8 цифр."))
            .help("Стойка принимает числа не длиннее 8 цифр, считая дробную часть."),
        Message::BlankInNumber { written, joined } => {
            Sentence::new(format!("В числе `{written}` есть пробел; стойка прочтёт `{joined}`."))
                .help("Удалите пробел или допишите пропущенный адрес.")
        }
        Message::LetterForDigit { word, digit, .. } => {
            Sentence::new(format!("В `{word}` вместо цифры {digit} стоит буква."))
                .help("Буква O и цифра 0, буква l и цифра 1 похожи, но стойка их различает.")
        }
        Message::ZeroForO { number } => {
            Sentence::new(format!("`{number}` прочитано как номер программы: первой должна стоять буква O."))
                .help("Номер программы начинается с буквы O, а не с нуля.")
        }
        Message::PrintedMinus => Sentence::new("Это типографское тире, а не минус; оно прочитано как минус.")
            .help("Стойка не знает этого символа. Замените его на `-`."),
        Message::CommaForPoint { word, .. } => {
            Sentence::new(format!("В `{word}` вместо десятичной точки стоит запятая."))
                .help("В G-коде дробную часть отделяют точкой.")
        }
        Message::CommentOpen => Sentence::new("Скобка не закрыта; остаток строки принят за комментарий.")
            .help("Закройте комментарий знаком `)`. Иначе стойка может пропустить и следующие кадры."),
        Message::CommentNested => Sentence::new("Внутри комментария есть ещё скобки.")
            .help("Для стойки комментарий кончается на первой `)`; остальное она прочтёт как слова."),
        Message::TextAfterSemicolon { text } => {
            Sentence::new(format!("Текст `{text}` после `;` принят за комментарий."))
                .help("На стойках FANUC и GSK знак `;` завершает кадр; комментарий пишут в скобках: `( … )`.")
        }
        Message::BlockTooLong { most } => Sentence::new(format!("Слишком много слов в кадре; допустимо: {most}."))
            .help("Не потерян ли конец строки? Остаток кадра не прочитан."),
        Message::TextTooLong { bytes, most } => {
            Sentence::new(format!("Размер текста в байтах: {bytes}; здесь читается не более {most}."))
                .help("Разделите программу или откройте только нужную часть.")
        }
        Message::EmptyProgram => {
            Sentence::new("Программы пока нет.").help("Введите или вставьте её либо выберите пример из галереи.")
        }
        Message::ProgramNumberZero => {
            Sentence::new("O0 — недопустимый номер программы.").help("Возьмите номер от O1 до O9999.")
        }
        Message::DuplicateProgram { number } => {
            Sentence::new(format!("Номер программы O{number} здесь повторяется."))
                .help("Под одним номером стойка хранит только одну программу.")
        }
        Message::NoEnd => Sentence::new("В конце программы нет M30 или M02.")
            .help("Поставьте в конце M30: иначе стойка остановится с ошибкой, а шпиндель и охлаждение останутся включёнными."),
        Message::MoreMessages { hidden } => Sentence::new(format!("Не показано сообщений: {hidden}."))
            .help("Сначала исправьте первые ошибки: остальные часто вызваны ими."),
        Message::TooManyMotions { most } => {
            Sentence::new(format!("Число перемещений превысило {most}; остальные не показаны."))
                .help("Не слишком ли мала какая-нибудь величина в цикле?")
        }
        Message::TooMuchWork { most } => {
            Sentence::new(format!("Расчёт циклов занял больше {most} шагов; дальнейшее не показано."))
                .help("Каждый вызов G70–G73 читает контур заново. Вызывайте длинные контуры реже и исправьте циклы, которые не выполняются.")
        }
        Message::Stopped { seconds } => {
            Sentence::new(format!("Расчёт остановлен через {} с; дальнейшее не показано.", number(*seconds)))
        }
        Message::CallNoNumber { code } => Sentence::new(format!("{code} не говорит, что вызвать."))
            .help("P – номер программы: M98 P1000 вызывает O1000, M98 P1000 L3 – три раза."),
        Message::ProgramNotFound { word } => {
            Sentence::new(format!("Программы с номером из `{word}` в тексте нет, вызов пропущен."))
                .help("Поместите подпрограмму за основной: O и номер, кадры, M99. Без L цифры перед последними четырьмя – число повторов: P51002 – пять раз O1002.")
        }
        Message::SequenceNotFound { sequence } => {
            Sentence::new(format!("Кадра N{sequence} в этой программе нет, переход пропущен."))
                .help("Поиск не выходит за пределы своей программы O.")
        }
        Message::CallTooDeep { most, .. } => {
            Sentence::new(format!("Вложено больше {most} вызовов; на этом выполнение заканчивается."))
                .help("Программа, вызывающая саму себя, или две, вызывающие друг друга, не кончаются никогда.")
        }
        Message::NoReturn => Sentence::new("Эта подпрограмма кончается без M99.")
            .help("Стойка остановится здесь с аварией. На рисунке программа идёт дальше за вызовом."),
        Message::EndlessMain => Sentence::new("M99 в основной программе возвращает к её началу, и так без конца; показан один проход.")
            .help("Так пишут при работе с податчиком прутка. Подпрограмма, вызванная через M98, вернулась бы к вызвавшей. Чтобы закончить программу, напишите M30."),
        Message::TooManyRepeats { most } => {
            Sentence::new(format!("Начиная отсюда переходами, циклами и вызовами выполнено больше {most} кадров; выполнение окончено."))
                .help("У цикла нет конца или слишком много проходов. Проверьте его условие, счётчик или L вызова.")
        }
        Message::TooMuchRepeated { most } => {
            Sentence::new(format!("Начиная отсюда переходами, циклами и вызовами выполнены кадры общей длиной больше {most} знаков; выполнение окончено."))
                .help("У цикла нет конца или слишком много проходов по длинным кадрам. Проверьте его условие, счётчик или L вызова.")
        }
        Message::TooManyRounds { most } => {
            Sentence::new(format!("Циклы и вызовы сделали больше {most} проходов; на этом выполнение заканчивается."))
                .help("Проверьте, что должно закончить этот цикл: условие, счётчик или L вызова.")
        }
        Message::TooManyMacroSteps { most } => {
            Sentence::new(format!("В переходах, циклах и вызовах вычислено больше {most} макрооператоров и выражений; на этом выполнение заканчивается."))
                .help("Проверьте, что должно закончить цикл, или вычисляйте меньше за один проход.")
        }
        Message::NotRun { number } => Sentence::new(format!("O{number:04} не выполняется: её никто не вызывает."))
            .help("Из нескольких программ текста выполняется первая. Чтобы увидеть другую, выберите её."),
        Message::NumberFromVariable { word } => Sentence::new(format!("`{word}`: номер после N и O нельзя брать из переменной."))
            .help("Напишите сам номер. Переменной его могут называть GOTO, P и Q."),
        Message::Macro { kind } => macro_fault(*kind),
        Message::MacroAlarm { number, words } => {
            Sentence::new(format!("Программа сама останавливается с аварией {number}: {words}"))
                .help("#3000 – собственная авария программы, обычно проверка данных: посмотрите условие перед ней и аргументы вызова.")
        }
        Message::SystemVariable { variable } => {
            Sentence::new(format!("#{variable} – переменная станка, здесь неизвестная; она читается как пустая."))
                .help("То, что от неё зависит, может быть показано неверно.")
        }
        Message::Foreign { origin: Origin::Mill } => Sentence::new("Это похоже на программу фрезерного станка.")
            .help("Здесь читаются токарные программы FANUC и GSK; ничего не выполнено. Чтобы всё же выполнить, задайте в настройке `recognise`: false."),
        Message::Foreign { origin: Origin::Printer } => Sentence::new("Это похоже на программу 3D-принтера.")
            .help("Здесь читаются токарные программы FANUC и GSK; ничего не выполнено. Чтобы всё же выполнить, задайте в настройке `recognise`: false."),
        Message::Foreign { origin } => Sentence::new(format!("Это похоже на программу для {}, которая здесь не поддерживается.", origin.name()))
            .help("Те же коды там значат другое, поэтому ничего не выполнено. Здесь читаются токарные программы FANUC и GSK. Чтобы всё же выполнить, задайте в настройке `recognise`: false."),
        Message::SystemGuessed { system } => {
            Sentence::new(format!("Прочитано в системе G-кодов {system:?}: это слово не из системы A."))
                .help("В системах B и C коды G90 и G91 – абсолютные и относительные размеры, G92 задаёт координаты или предел оборотов, G77 G78 G79 (B) – циклы. Систему можно указать в настройке.")
        }
        Message::ReferenceNumber { word } => Sentence::new(format!("`{word}` не называет опорной точки: с G30 идут P2, P3 или P4.")),
        Message::NotAtReference { x, z } => {
            Sentence::new(format!("G27 кончается не в опорной точке, здесь она X{} Z{}.", number(*x), number(*z)))
                .help("G27 проверяет, что инструмент там, иначе авария.")
        }
        Message::NoIntermediate => Sentence::new("У G29 нет промежуточной точки: раньше не было G28 или G30."),
        Message::MachineZero { x, z } => {
            Sentence::new(format!("G53 считает от нуля станка; здесь за него взята опорная точка X{} Z{}.", number(*x), number(*z)))
                .help("Где этот нуль, знает только станок. Укажите в настройке `refPoint`, где стоят суппорты в исходном положении.")
        }
        Message::OffsetNumber { word } => Sentence::new(format!("`{word}` не называет строки таблицы корректоров.")),
        Message::TipNumber { word } => Sentence::new(format!("`{word}` — не номер положения вершины: он от 0 до 9.")),
        Message::DataPassedOver => Sentence::new("Отсюда до G11 идут данные для таблиц стойки; они пропущены."),
        Message::HoleInForce { word, hole, .. } => Sentence::new(format!("`{word}` нельзя писать, пока действует {hole}."))
            .help("Перед этим напишите G80: до него каждое X, Z или C — ещё одно отверстие."),
        Message::PeckZero { word } => Sentence::new(format!("`{word}` не годится как глубина за один ход."))
            .help("Q — глубина каждого хода в микрометрах, например Q5000. Без Q отверстие сверлится за один ход."),
        Message::HoleNoDepth { code } => Sentence::new(format!("У {code} нет глубины."))
            .help("Дно отверстия у G83 G84 G85 задаёт Z или W, у G87 G88 G89 – X или U."),
        Message::HoleOfOthers { code } => {
            Sentence::new(format!("В системе A стоек FANUC {code} нет; показано как на станках, где он есть."))
                .help("Сверление вдоль Z от начальной точки и обратно. На токарных FANUC сверлят по G83 или G74.")
        }
        Message::MakerG { word } => Sentence::new(format!("`{word}` зависит от станка и пропущен."))
            .help("Такие номера изготовители занимают под свои коды. Что он делает, не показано."),
        Message::UnknownG { word } => Sentence::new(format!("G-кода `{word}` у этой стойки нет."))
            .help("Весь кадр не выполняется. Проверьте номер."),
        Message::UnknownM { word } => {
            Sentence::new(format!("`{word}` есть только на некоторых станках; здесь этот код пропущен."))
                .help("Его действие описано в руководстве к станку.")
        }
        Message::NotSupported { what } => Sentence::new(format!("Здесь не поддерживается: {what}."))
            .help("Это не ошибка программы. Дальнейшие перемещения могут быть неверны и показаны бледно."),
        Message::PointNotAllowed { word } => {
            Sentence::new(format!("В `{word}` должно стоять целое число, без точки."))
        }
        Message::MinusNotAllowed { word } => {
            Sentence::new(format!("В `{word}` не может стоять отрицательное число."))
        }
        Message::DuplicateWord { address, used } => {
            Sentence::new(format!("Адрес {address} стоит в кадре дважды; действует `{used}`."))
                .help("Стойка берёт последнее слово или выдаёт ошибку. Удалите неверное.")
        }
        Message::SameGroup { dropped, used } => {
            Sentence::new(format!("`{dropped}` и `{used}` исключают друг друга; действует `{used}`."))
                .help("Это коды одной модальной группы. В кадре действует последний из них.")
        }
        Message::AbsoluteAndIncremental { absolute, incremental, used } => {
            Sentence::new(format!("`{absolute}` и `{incremental}` задают одну и ту же ось; действует `{used}`."))
                .help("Стойки ведут себя по-разному: FANUC берёт последнее слово, GSK — абсолютное.")
        }
        Message::ToolWithSetting { word } => {
            Sentence::new(format!("`{word}` нельзя писать в одном кадре с G50, G10 или G04."))
                .help("Вызывайте инструмент отдельным кадром.")
        }
        Message::ShortTool { word, offset } => Sentence::new(format!(
            "В `{word}` нет номера позиции: выбирается корректор {offset}, а револьверная головка не поворачивается."
        ))
        .help("На стойке с четырёхзначным T пишут позицию и корректор, например T0101."),
        Message::ToolNumber { word } => Sentence::new(format!("`{word}` — недопустимый номер инструмента."))
            .help("Укажите позицию и корректор, например T0101."),
        Message::G90AsAbsolute => {
            Sentence::new("На токарном станке G90 — цикл продольного точения, а не абсолютные координаты.")
                .help("Здесь X и Z всегда абсолютные, а U и W — приращения. Сейчас следующий X или Z запустит цикл: удалите G90.")
        }
        Message::LetterIInG92 { as_taper } => {
            let reading = if *as_taper { "конусность, то есть R" } else { "число ниток на дюйм" };
            Sentence::new(format!("I в G92 прочитано как {reading}."))
                .help("FANUC читает I как конусность (старая запись R), GSK — как число ниток на дюйм.")
        }
        Message::G28NoAxis => Sentence::new("В G28 не указана ось, поэтому перемещения нет.")
            .help("Чтобы вывести обе оси в референтную точку, запишите G28 U0 W0."),
        Message::DwellNoTime => Sentence::new("В G04 нет времени, поэтому выдержки не будет.")
            .help("Задайте X или U в секундах либо P в миллисекундах."),
        Message::AxisNotHere { word } => Sentence::new(format!("Ось Y из `{word}` здесь не поддерживается: рисуются только X, Z и C."))
            .help("Перемещения X и Z всё же показаны, отсюда бледно. Сообщается один раз."),
        Message::PlaneNotHere { word } => Sentence::new(format!("Дуги в плоскости {word} вне G12.1 здесь не поддерживаются."))
            .help("Для точения нужна G18. Фрезерные дуги на торце пишут внутри G12.1. Сообщается один раз."),
        Message::CAxisNotConnected => Sentence::new("Здесь движется ось C, но раньше её ничто не подключило.")
            .help("Код зависит от станка: например, M45 и G28 H0. В режиме шпинделя C вызывает аварию."),
        Message::LiveToolStopped => Sentence::new("Здесь режет приводной инструмент, но раньше его ничто не запустило.")
            .help("Код зависит от станка: например, M13 или M14 с S."),
        Message::PolarForbidden { word } => Sentence::new(format!("`{word}` между G12.1 и G13.1 не допускается."))
            .help("Там могут стоять только G01 G02 G03 G04 G40 G41 G42 G65 G66 G67 G98 G99: подойдите по G01 или сначала выйдите по G13.1."),
        Message::PolarFrame { word } => Sentence::new(format!("`{word}` меняет координаты между G12.1 и G13.1."))
            .help("Задайте нуль до G12.1: X0 должен быть осью шпинделя."),
        Message::PolarNotAlone { code, other } => {
            Sentence::new(format!("{code} должен стоять в кадре один, без `{other}`.")).help("Перенесите остальные слова в отдельный кадр.")
        }
        Message::PlaneCompensation { code } => Sentence::new(format!("{code} стоит под G41 или G42."))
            .help("Коррекция начинается и кончается внутри: после G12.1 или G07.1 C… и по G40 до G13.1 или G07.1 C0."),
        Message::PolarFeedPerTurn => Sentence::new("Подача на оборот (G99) в полярной интерполяции не имеет смысла.")
            .help("Шпиндель там лишь поворачивается: напишите G98 и F в мм/мин."),
        Message::PolarNoRadius => Sentence::new("У G41 или G42 здесь нет радиуса фрезы, поэтому коррекции нет.")
            .help("Задайте радиус в корректоре; тогда центр фрезы держится на этом расстоянии от пути."),
        Message::PolarAngle { word } => Sentence::new(format!("`{word}` похоже на градусы; между G12.1 и G13.1 C – длина в мм."))
            .help("Путь пишется в плоскости: X – диаметр, вправо, C – в мм, вверх."),
        Message::PolarCenter { distance } => {
            Sentence::new(format!("Путь проходит в {} мм от оси шпинделя, где C пришлось бы вращать бесконечно быстро.", number(*distance)))
                .help("Стойка там замедлится или остановится с аварией. Держитесь дальше от центра.")
        }
        Message::PlaneLeftOn { code, off } => Sentence::new(format!("К `{code}` интерполяция с осью C ещё включена."))
            .help(format!("Перед этим напишите {off} отдельным кадром.")),
        Message::CylinderFormat => Sentence::new("G07.1 требует C с радиусом цилиндра, и больше ничего.")
            .help("G07.1 C30 включает с радиусом 30 мм, G07.1 C0 выключает. Дважды включать нельзя."),
        Message::CylinderForbidden { word } => Sentence::new(format!("`{word}` в цилиндрической интерполяции не допускается."))
            .help("Там могут стоять только G01–G04 и G40–G42, дуги задаются через R, а быстрые перемещения – до G07.1 или после G07.1 C0."),
Message::DwellWithPoint { word } => Sentence::new(format!("В `{word}` стоит точка; прочитано как секунды."))
            .help("У FANUC P – миллисекунды без точки, иначе авария; Haas читает секунды. X или U везде задают секунды."),
                Message::FeedMissing => Sentence::new("Не задана подача: до начала резания не было F, отличного от нуля.")
            .help("Сразу после включения стойка здесь остановится, иначе будет резать с F прежней программы. Добавьте F, например F0.2 при G99 (мм/об) или F200 при G98 (мм/мин)."),
        Message::LeadMissing { code } => Sentence::new(format!("В {code} не задан ход резьбы."))
            .help("F задаёт ход резьбы в мм; у однозаходной резьбы он равен шагу."),
        Message::FeedUnit { feed, per_turn: true } => {
            let feed = number(*feed);
            Sentence::new(format!("F{feed} при G99 — это {feed} мм на оборот шпинделя."))
                .help("Для резания это слишком много. Может быть, нужен G98 (мм/мин)? Смените режим подачи стойки или запишите G98.")
        }
        Message::FeedUnit { feed, per_turn: false } => {
            let feed = number(*feed);
            Sentence::new(format!("F{feed} при G98 — это всего {feed} мм в минуту."))
                .help("Может быть, нужен G99 (мм/об)? Смените режим подачи стойки или запишите G99.")
        }
        Message::FeedNotRepeated { feed, per_turn } => {
            let (code, unit) = if *per_turn { ("G99", "мм/об") } else { ("G98", "мм/мин") };
            Sentence::new(format!("После {code} прежняя подача F{} считается в {unit}.", number(*feed)))
                .help("При смене режима подачи задавайте F заново.")
        }
        Message::SpindleStopped => Sentence::new("Инструмент режет при неподвижном шпинделе.")
            .help("Включите шпиндель (M03 или M04) до начала резания."),
        Message::NoSpeedClamp => {
            Sentence::new("Включена постоянная скорость резания (G96), но обороты шпинделя не ограничены.")
                .help("К центру обороты растут без предела. Сначала задайте ограничение, например G50 S2000.")
        }
        Message::ClampReversed { lowest, highest } => Sentence::new(format!(
            "Наименьшие обороты шпинделя Q{} выше наибольших S{}.",
            number(*lowest),
            number(*highest)
        )),
        Message::ThreadAtSurfaceSpeed { code } => {
            Sentence::new(format!("{code} нарезает резьбу при G96, когда обороты шпинделя меняются вместе с X."))
                .help("Задайте постоянные обороты (G97 S…): каждый проход должен попадать в ту же нитку.")
        }
        Message::ArcNoCenter { code } => Sentence::new(format!("В {code} нет ни R, ни I и K."))
            .help("Задайте радиус R или центр относительно начальной точки дуги: I и K; или имелась в виду G01? FANUC идёт прямо, если параметр не требует аварии."),
        Message::ArcRadiusTooSmall { radius, distance } => Sentence::new(format!(
            "Радиус R{} слишком мал: от начала до конца дуги {} мм.",
            number(*radius),
            number(*distance)
        ))
        .help(format!(
            "Радиус должен быть не меньше половины этого расстояния: {} мм. Помните, что X — это диаметр.",
            number(distance / 2.0)
        )),
        Message::ArcEndOffCircle { start_radius, end_radius } => Sentence::new(format!(
            "Конечная точка не лежит на окружности: от центра до начала дуги {} мм, а до конца {} мм.",
            number(*start_radius),
            number(*end_radius)
        ))
        .help("I — приращение по X (на радиус) от начальной точки к центру, K — то же по Z; оба со знаком."),
        Message::ArcRadiusNegative { radius } => {
            Sentence::new(format!("Эта стойка не принимает R{}.", number(*radius)))
                .help("Дуги больше 180° задают через I и K.")
        }
        Message::ArcNowhere => {
            Sentence::new("Дуга кончается там же, где начинается, поэтому с R перемещения нет.")
                .help("Полную окружность задают через I и K.")
        }
        Message::TaperBeyondStart { taper, limit, axis } => {
            let (part, rule) = if *axis == 'U' { ("половины", "|U/2|") } else { ("длины", "|W|") };
            Sentence::new(format!(
                "`R{}` больше {part} `{axis}{}`: резание начнётся за начальной точкой цикла.",
                number(*taper),
                number(*limit)
            ))
            .help(format!("Если знаки R и {axis} различны, должно быть |R| ≤ {rule}."))
        }
        Message::TaperNotExtended { taper, needed, crossing, wanted, axis } => Sentence::new(format!(
            "R{} взято с чертежа без учёта начальной точки цикла: конус выходит на край заготовки в {axis}{}, а не в {axis}{}.",
            number(*taper),
            number(*crossing),
            number(*wanted)
        ))
        .help(format!(
            "Резание начинается вне заготовки, поэтому R по модулю должно быть больше в той же пропорции: R{}.",
            number(*needed)
        )),
        Message::ContourNotNamed { code } => Sentence::new(format!("В {code} нужны и P, и Q."))
            .help("P — номер N первого кадра контура, Q — номер последнего."),
        Message::ContourNotFound { word } => {
            Sentence::new(format!("Нет кадра с номером, указанным в `{word}`."))
                .help("P указывает первый кадр контура, Q — последний; он должен стоять ниже в той же программе.")
        }
        Message::ContourFirstBlock { code } => {
            Sentence::new(format!("В первом кадре контура для {code} нет перемещения по G00 или G01."))
                .help("Этот кадр подводит инструмент от начальной точки цикла к началу контура.")
        }
        Message::ContourIllegal { word } => {
            Sentence::new(format!("`{word}` нельзя писать между кадрами P и Q."))
                .help("Контур задают только кодами G00, G01, G02 и G03. Цикл не выполняется.")
        }
        Message::ContourReachesOver { code, word, line } => {
            Sentence::new(format!("P и Q у {code} захватывают другую операцию: `{word}` в строке {line}."))
                .help("Проверьте номера кадров: один может стоять дважды, или Q называет кадр далеко позади. Цикл не выполняется.")
        }
        Message::ContourCall { word } => {
            Sentence::new(format!("`{word}` вызывает подпрограмму внутри контура."))
                .help("Запишите перемещения прямо между кадрами P и Q. Цикл не выполняется.")
        }
        Message::ContourBothAxes { code, other } => Sentence::new(format!(
            "В первом кадре контура для {code} указана и ось {other}, хотя перемещения по ней нет."
        ))
        .help("Две оси в этом кадре стойка понимает как тип II (с карманами). Для типа I удалите это слово."),
        Message::ContourTypeTwo { code } => Sentence::new(format!(
            "Первый кадр контура для {code} перемещает обе оси; эта стойка такого не принимает."
        ))
        .help("Без типа II (с карманами) в этом кадре может перемещаться только одна ось."),
        Message::ContourTurnsBack { code, axis, line, .. } => {
            Sentence::new(format!("Контур для {code} в строке {line} поворачивает назад по {axis}."))
                .help("Контур типа I идёт по каждой оси только в одну сторону; тип II (две оси в первом кадре) допускает карманы по глубине.")
        }
        Message::ContourBeyondStart { code, axis } => {
            Sentence::new(format!("Контур для {code} выходит по {axis} за начальную точку цикла."))
                .help("Начальная точка цикла должна лежать вне контура.")
        }
        Message::ContourNothingToCut { code } => Sentence::new(format!("Между начальной точкой и этим контуром {code} нечего снимать."))
            .help("Контуру нужны глубина от начальной точки и длина: одного первого и последнего кадра мало."),
        Message::ContourOpenEnd { word, .. } => {
            Sentence::new(format!("После `{word}` в последнем кадре контура нет перемещения."))
                .help("Контур не может кончаться фаской, скруглением или углом без конечной точки.")
        }
        Message::DepthNotPositive { code, depth: None } => {
            Sentence::new(format!("В {code} не задана глубина прохода."))
                .help("Задайте её в первом кадре цикла, например G71 U2 R0.5 или G72 W2 R0.5. U и W рядом с P и Q — это припуск.")
        }
        Message::DepthNotPositive { code, depth: Some(depth) } => {
            Sentence::new(format!("Глубина прохода {} в {code} должна быть больше нуля.", number(*depth)))
                .help("Её пишут без знака: направление цикл определяет по контуру. Цифры меньше 0,001 мм отбрасываются.")
        }
        Message::AllowanceSign { word } => {
            Sentence::new(format!("Припуск `{word}` направлен внутрь детали."))
                .help("При наружной обработке U положительный, в отверстии — отрицательный; W направлен против хода резания.")
        }
        Message::PatternPasses { passes: None } => Sentence::new("В G73 не задано число проходов.")
            .help("Задайте его адресом R в первом кадре цикла, например G73 U9 W2 R5."),
        Message::PatternPasses { passes: Some(passes) } => {
            Sentence::new(format!("Недопустимое число проходов в G73: {}.", number(*passes)))
        }
        Message::TooManyPasses { code, most } => {
            Sentence::new(format!("Число перемещений в {code} превысит {most}; цикл не выполняется."))
                .help("Не слишком ли мала глубина прохода, шаг или глубина первого прохода? Числа без точки могут считаться в микрометрах.")
        }
        Message::PeckNegative { word } => {
            Sentence::new(format!("В `{word}` не может стоять отрицательное число."))
                .help("Шаг врезания и смещение пишут без знака: направление задаёт конечная точка.")
        }
        Message::PeckMissing { code, address } => {
            Sentence::new(format!("В {code} есть перемещение по этой оси, но нет {address}."))
                .help("P — шаг по X (на радиус), Q — шаг по Z.")
        }
        Message::ReliefNegative { word } => {
            Sentence::new(format!("Отвод в сторону `{word}` здесь не может быть отрицательным."))
                .help("Его направление следует из направления смещения.")
        }
        Message::AmountInMillimetres { word } => Sentence::new(format!("`{word}` прочитано в мм (при G20 в дюймах)."))
            .help("Стойки FANUC и GSK считают P и Q в микрометрах, без точки: 5 мм — это 5000. Единицу задаёт настройка pqUnit."),
        Message::ThreadAngle { angle } => {
            Sentence::new(format!("Угол инструмента {}° в G76 недопустим.", number(*angle)))
                .help("FANUC принимает 80, 60, 55, 30, 29 и 0 градусов: это две последние цифры P.")
        }
        Message::ThreadLeastDepth { least, height } => Sentence::new(format!(
            "Наименьшая глубина прохода {} мм больше высоты профиля резьбы {} мм.",
            number(*least),
            number(*height)
        ))
        .help("Q первого кадра и P второго задают в микрометрах."),
        Message::ThreadNoDepth { word } => {
            let what = if *word == 'P' {
                "высота профиля резьбы P"
            } else {
                "глубина первого прохода Q"
            };
            Sentence::new(format!("В G76 {what} должна быть больше нуля."))
                .help("P — высота профиля резьбы, Q — глубина первого прохода; обе на радиус, в микрометрах.")
        }
        Message::ThreadStartInside { start, crest } => Sentence::new(format!(
            "G76 начинается в X{}, то есть внутри металла: вершины резьбы лежат на X{}.",
            number(*start),
            number(*crest)
        ))
        .help("После каждого прохода инструмент возвращается на начальный X: там он не должен касаться детали."),
        Message::CornerNoMove { word } => {
            Sentence::new(format!("После `{word}` нет прямолинейного перемещения: угол не образуется."))
                .help("В следующем кадре нужно перемещение по G01 (для `,C` и `,R` также G02 и G03).")
        }
        Message::CornerTooLarge { word } => Sentence::new(format!("`{word}` больше соседних перемещений.")),
        Message::CornerNone { word } => {
            Sentence::new(format!("`{word}`: эти два перемещения не образуют угла."))
                .help("Путь идёт прямо дальше или поворачивает назад по той же линии.")
        }
        Message::CornerAxis { word, .. } => {
            Sentence::new(format!("`{word}` не подходит к следующему перемещению."))
                .help("Фаска или скругление без запятой соединяет перемещение по одной оси с перемещением по другой; знак — это направление следующего перемещения.")
        }
        Message::CornerTwice { word, other } => {
            Sentence::new(format!("`{word}` и `{other}`: в кадре может быть только одна фаска или одно скругление."))
        }
        Message::CornerInThread { word } => {
            Sentence::new(format!("`{word}`: в кадре резьбы не может быть фаски или скругления."))
                .help("Запишите фаску в кадре с G01.")
        }
        Message::CornerWithCompensation { word } => {
            Sentence::new(format!("`{word}` стоит в кадре, где коррекция включается или отменяется."))
                .help("Запишите G40, G41 и G42 в кадре без фаски и скругления.")
        }
        Message::CycleWord { code, word } => {
            Sentence::new(format!("`{word}` не может стоять в кадре с {code}."))
                .help("Контур задают кадры от P до Q; в кадре цикла пишут P, Q, U, W и F, S, T.")
        }
        Message::CycleAxis { code, word } => Sentence::new(format!("`{word}`: в {code} есть только оси X и Z.")),
        Message::CyclePlane { code, .. } => {
            Sentence::new(format!("{code} работает только в плоскости G18.")).help("Запишите перед ним G18.")
        }
        Message::FinishStart { roughed_x, roughed_z } => Sentence::new(format!(
            "G70 начинается не там, откуда контур обрабатывался начерно: X{} Z{}.",
            number(*roughed_x),
            number(*roughed_z)
        ))
        .help("Первый и последний ход ускоренные: из другой точки они могут задеть деталь."),
        Message::FinishWithoutRoughing { first, last } => {
            Sentence::new(format!("Контур N{first}–N{last} обрабатывается G70, но чернового G71, G72 или G73 для него нет."))
                .help("Заготовка близка к готовому размеру или в P и Q указаны не те кадры?")
        }
        Message::AngleNoPoint { word, .. } => Sentence::new(format!("По `{word}` нельзя найти конечную точку."))
            .help("Углы отсчитывают от +Z против часовой стрелки. Две прямые должны пересекаться; для одной прямой, кроме угла, нужен X или Z."),
        Message::CompensationOnArc { code } => {
            Sentence::new(format!("Коррекцию нельзя включать или отменять на дуге ({code})."))
                .help("Пишите G40, G41 и G42 в кадре с прямолинейным перемещением (G00 или G01).")
        }
        Message::CompensationOvercut { radius, .. } => {
            Sentence::new(format!("Вершина R{} здесь не проходит: она врежется в контур.", number(*radius)))
                .help("Уступ слишком низкий, канавка слишком узкая или внутренняя дуга слишком мала для такой вершины.")
        }
        Message::CompensationNoIntersection { radius } => Sentence::new(format!(
            "При радиусе вершины R{} эти два перемещения не пересекаются.",
            number(*radius)
        )),
        Message::CompensationPlane => Sentence::new("Пока действует G41 или G42, менять плоскость нельзя.")
            .help("Сначала запишите G40."),
        Message::LeadRunsOut { lead } => {
            Sentence::new(format!("Ход резьбы в G34 станет равен {} мм.", number(*lead)))
                .help("K — изменение хода за один оборот; до самого конца ход должен оставаться больше нуля.")
        }
        Message::CompensationIdle { code } => {
            Sentence::new(format!("Коррекция на радиус вершины включена, но в этом {code} она не действует."))
                .help("Резьбу нарезают без неё; для G90 и G94 в корректоре должен быть задан радиус вершины.")
        }
    }
}

/// What is wrong with a macro.
fn macro_fault(kind: FaultKind) -> Sentence {
    match kind {
        FaultKind::Overflow => Sentence::new("Значение слишком велико для макропрограммы."),
        FaultKind::DivisionByZero => Sentence::new("Здесь деление на нуль.").help("Пустая переменная считается за 0."),
        FaultKind::UnknownFunction => Sentence::new("Такой функции нет.")
            .help("Есть SIN COS TAN ASIN ACOS ATAN SQRT ABS ROUND FIX FUP LN EXP POW MOD, значения пишут в `[ ]`."),
        FaultKind::Expression => Sentence::new("Это выражение не прочитать.")
            .help("Пишите `#1+2`, `[#1-#2]*3`, `SIN[#4]`: скобки квадратные, между значениями знак."),
        FaultKind::BracketOpen => Sentence::new("У этой `[` нет `]`."),
        FaultKind::NumberOrCondition => Sentence::new("Условие стоит там, где нужно число, или наоборот.")
            .help("Условие сравнивает: `[#1 GT 10]`, есть EQ NE GT GE LT LE."),
        FaultKind::VariableNumber => Sentence::new("Такой переменной нет.")
            .help("Локальные #1–#33, общие #100–#199 и #500–#999, системные от #1000."),
        FaultKind::ReadOnly => Sentence::new("Эту переменную можно только читать."),
        FaultKind::BracketsTooDeep => Sentence::new("Вложено больше пяти скобок."),
        FaultKind::FunctionArgument => Sentence::new("Для этого значения у функции нет результата.")
            .help("Например, корень или логарифм отрицательного числа."),
        FaultKind::CallsTooDeep => Sentence::new("Слишком много вложенных вызовов макропрограмм."),
        FaultKind::EndMissing => Sentence::new("У этого DO нет END с тем же номером."),
        FaultKind::Format => Sentence::new("Этот оператор макропрограммы не прочитать.")
            .help("Например, `#1=#2+1`, `IF[#1 GT 5]GOTO 10`, `IF[#1 EQ 0]THEN #2=1`, `WHILE[#1 LE 9]DO1` … `END1`."),
        FaultKind::LoopNumber => Sentence::new("Номер цикла – 1, 2 или 3, и END относится к идущему DO."),
        FaultKind::WordsBehind => Sentence::new("Оператор макропрограммы должен стоять в кадре один.")
            .help("Слова станка поместите в отдельный кадр."),
        FaultKind::JumpTarget => Sentence::new("GOTO требует номер кадра от 1 до 99999."),
        FaultKind::ArgumentLetter => Sentence::new("Эта буква не может передать аргумент макропрограмме.")
            .help("G, L, N, O и P использовать нельзя."),
    }
}

pub(super) fn fix_title(message: &Message) -> String {
    match message {
        Message::CommentOpen => "Закрыть комментарий".into(),
        Message::CommaForPoint { .. } => "Поставить десятичную точку".into(),
        Message::LetterForDigit { digit, .. } => format!("Поставить цифру {digit}"),
        Message::ZeroForO { .. } => "Поставить букву O".into(),
        Message::PrintedMinus => "Поставить минус".into(),
        other => sentence(other).message,
    }
}

pub(super) fn motion(motion: &Motion, passes: Option<u32>) -> String {
    let kind = match motion.kind {
        MotionKind::Rapid => "ускоренное перемещение в",
        MotionKind::Feed => "перемещение на подаче в",
        MotionKind::ArcClockwise => "дуга G02 до",
        MotionKind::ArcCounterclockwise => "дуга G03 до",
        MotionKind::Thread => "нарезание резьбы до",
        MotionKind::Dwell => "выдержка в",
    };
    let to = end_of(motion);
    if let Some(seconds) = motion.seconds {
        return format!("выдержка {} с в {to}", number(seconds));
    }
    let Some(cycle) = motion.cycle else {
        return format!("{kind} {to}");
    };
    let step = match cycle.step {
        Step::Infeed => "подвод",
        Step::Cut => "резание",
        Step::PullOut => "сбег резьбы",
        Step::Retract => "отвод",
        Step::Return => "возврат",
        Step::Approach => "подход",
        Step::Escape => "отскок под 45°",
        Step::Contour => "проход по контуру",
        Step::Relief => "отвод в сторону",
        Step::Stepover => "смещение",
    };
    let manner = match motion.kind {
        MotionKind::Rapid => "на ускоренном ходу",
        MotionKind::Thread => "синхронно со шпинделем",
        _ => "на подаче",
    };
    let preposition = if matches!(cycle.step, Step::Cut | Step::PullOut) { "до" } else { "в" };
    let pass = match passes {
        Some(all) if cycle.pass > 0 => format!(", проход {} из {all}", cycle.pass),
        None if cycle.pass > 0 => format!(", проход {}", cycle.pass),
        _ => String::new(),
    };
    format!("{}{pass}: {step} {manner} {preposition} {to}", cycle.cycle.code())
}
