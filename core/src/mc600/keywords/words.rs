//! The table itself, in alphabetical order, marks first. System variables are in `system.rs`.

use super::ABSENT;
use crate::language::Support::Full;

words! {
    // word, kind, section, support; syntax, summary, example
    Multiply "*" "operator" EXPRESSIONS Full
        "a * b" "Product of two numbers." "10 PRINT 100*2";
    Plus "+" "operator" EXPRESSIONS Full
        "a + b" "Sum of two numbers, or two strings joined." "10 PRINT 2+2;\"FILE\"+\"NAME\"";
    Minus "-" "operator" EXPRESSIONS Full
        "a - b, -a" "Difference of two numbers, or a number with its sign changed." "10 PRINT 55-142;-(-4)";
    Divide "/" "operator" EXPRESSIONS Full
        "a / b" "Quotient of two numbers." "10 PRINT 6400/4;5/2";
    Less "<" "operator" EXPRESSIONS Full
        "a < b" "-1 if a is less than b, else 0." "10 PRINT 14<66";
    LessEqual "<=" "operator" EXPRESSIONS Full
        "a <= b" "-1 if a is at most b, else 0." "10 PRINT 14<=66";
    NotEqual "<>" "operator" EXPRESSIONS Full
        "a <> b" "-1 if a and b differ, else 0." "10 PRINT \"YES\"<>\"NO\"";
    Equal "=" "operator" EXPRESSIONS Full
        "a = b" "-1 if a and b are equal, else 0; behind a variable, stores." "10 PRINT 1=5-4";
    Greater ">" "operator" EXPRESSIONS Full
        "a > b" "-1 if a is greater than b, else 0." "10 PRINT 14>66";
    GreaterEqual ">=" "operator" EXPRESSIONS Full
        "a >= b" "-1 if a is at least b, else 0." "10 PRINT 15>=15";
    QuestionMark "?" "statement" KEYWORDS Full
        "? [list]" "Short for PRINT." "10 ? \"HELLO\"";
    Power "^" "operator" EXPRESSIONS Full
        "a ^ b" "a to the power of b." "10 PRINT 3^-2";
    Pi "{pi}" "constant" RULES Full
        "{pi}" "The ratio of a circle's circumference to its diameter." "10 PRINT COS(60*{pi}/180)";

    Abs "ABS" "function" KEYWORDS Full
        "ABS(number)" "The number without its sign." "10 PRINT ABS(-5)";
    And "AND" "operator" KEYWORDS Full
        "a AND b" "Bits set in both, of 32; so also: both true." "10 PRINT 17 AND 194;5>3 AND 2>1";
    Asc "ASC" "function" KEYWORDS Full
        "ASC(string)" "Code of the string's first character." "10 PRINT ASC(\"Z\")";
    Atn "ATN" "function" KEYWORDS Full
        "ATN(number)" "Angle in radians whose tangent is the number." "10 PRINT ATN(1)*4";
    Auto "AUTO" "command" KEYWORDS Full
        "AUTO [start][,increment]" "Offers line numbers, from 10 in tens if not told, until an empty line or Ctrl-C." "AUTO 100,25";
    ChrS "CHR$" "function" KEYWORDS Full
        "CHR$(code)" "The character with that code, 0 to 255." "10 PRINT CHR$(65)";
    Cont "CONT" "command" KEYWORDS Full
        "CONT" "Goes on after STOP, END or Ctrl-C, unless the program was changed or an error came." "CONT";
    Copy "COPY" "command" FILESYSTEM Full
        "COPY \"from\",\"to\"" "Copies a file; a disk alone takes it under the same name." "COPY \"A:X.BAS\",\"B:\"";
    Cos "COS" "function" KEYWORDS Full
        "COS(angle)" "Cosine of an angle in radians." "10 PRINT COS(0)";
    Data "DATA" "statement" KEYWORDS Full
        "DATA constant,..." "Holds constants for READ." "10 READ A,B$: PRINT A;B$\n20 DATA 12,\"A, B\"";
    Del "DEL" "command" KEYWORDS Full
        "DEL [first][-[last]],..." "Deletes lines of the program: one, a range, or several of them." "DEL 100-200,300";
    Dim "DIM" "statement" KEYWORDS Full
        "DIM name(size,...),..." "Makes arrays; each of up to four subscripts runs from 0 to its size." "10 DIM Z(5,7),N$(20): Z(5,7)=3: PRINT Z(5,7)";
    Else "ELSE" "statement" KEYWORDS Full
        "IF condition THEN ... ELSE ..." "What an IF does when its condition is false." "10 A=2: IF A=1 THEN PRINT \"ONE\" ELSE PRINT \"OTHER\"";
    End "END" "statement" KEYWORDS Full
        "END" "Ends the program; CONT goes on behind it." "10 PRINT \"FIRST\"\n20 END\n30 PRINT \"NEVER\"";
    Erase "ERASE" "command" KEYWORDS Full
        "ERASE \"mask\"" "Erases the files that match the mask; a star stands for any characters, a question mark for one." "ERASE \"A:FIL*.BAS\"";
    Exp "EXP" "function" KEYWORDS Full
        "EXP(number)" "e to the power of the number." "10 PRINT EXP(1)";
    Fclose "FCLOSE" "not-implemented" KEYWORDS ABSENT
        "FCLOSE handle%" "Would close an open file." "10 FCLOSE F%";
    Files "FILES" "command" KEYWORDS Full
        "FILES [\"mask\"]" "Lists the files that match the mask, or all of a disk, with their sizes and what is free." "FILES \"B:FIL*.BAS\"";
    For "FOR" "statement" KEYWORDS Full
        "FOR variable = start TO limit [STEP increment]" "Repeats what stands before its NEXT while the variable counts, at least once." "10 FOR L=3 TO 1 STEP -1: PRINT L;: NEXT";
    Format "FORMAT" "command" FILESYSTEM Full
        "FORMAT \"A:\"|\"B:\"" "Empties a disk: its files are lost." "FORMAT \"B:\"";
    Get "GET" "not-implemented" KEYWORDS ABSENT
        "GET variable,..." "Would read a key without waiting." "10 GET A$";
    GoTo "GO TO" "statement" KEYWORDS Full
        "GO TO line" "GOTO, in two words." "10 GO TO 30\n20 PRINT \"NEVER\"\n30 PRINT \"HERE\"";
    Gosub "GOSUB" "statement" KEYWORDS Full
        "GOSUB line" "Goes to a line and comes back at RETURN." "10 GOSUB 100: PRINT \"BACK\": END\n100 PRINT \"THERE\": RETURN";
    Goto "GOTO" "statement" KEYWORDS Full
        "GOTO line" "Goes to a line; without a number, to line 0." "10 N=N+1: PRINT N;\n20 IF N<3 THEN GOTO 10";
    Gotoxy "GOTOXY" "not-implemented" KEYWORDS ABSENT
        "GOTOXY column,row" "Would place the terminal's cursor." "100 GOTOXY 50,10";
    If "IF" "statement" KEYWORDS Full
        "IF condition THEN line|statements [ELSE line|statements]" "Does the rest of the line, or goes to a line, when the condition is not zero." "10 N=5: IF N>3 THEN PRINT \"LARGER\" ELSE 30\n20 END\n30 PRINT \"NOT LARGER\"";
    Input "INPUT" "statement" KEYWORDS Full
        "INPUT [\"prompt\";] variable,..." "Asks at the console, with the prompt and a question mark, for values with commas between." "10 INPUT \"SPEED\";S%";
    Insta "INSTA" "function" KEYWORDS Full
        "INSTA()" "The card's eight digital inputs, input 0 in bit 0." "120 PRINT INSTA()";
    Int "INT" "function" KEYWORDS Full
        "INT(number)" "The greatest whole number that is not above the number." "120 PRINT INT(-12.34)";
    Intdisable "INTDISABLE" "motion" INTERRUPTS Full
        "INTDISABLE()" "Holds interrupts back." "10 INTDISABLE()";
    Intenable "INTENABLE" "motion" INTERRUPTS Full
        "INTENABLE()" "Lets interrupts in." "10 INTENABLE()";
    Intsetup "INTSETUP" "motion" INTERRUPTS Full
        "INTSETUP(line,source,edge)" "Names the line that an interrupt source calls, and the edge: 0 off, 1 rising, 2 falling, 3 both." "10 INTSETUP(1000,3,1)";
    Intsta "INTSTA" "function" KEYWORDS Full
        "INTSTA()" "INSTA, as the manual's own example spells it." "120 PRINT INTSTA()";
    LeftS "LEFT$" "function" KEYWORDS Full
        "LEFT$(string,count)" "The first characters of a string." "10 PRINT LEFT$(\"MC-600\",2)";
    Len "LEN" "function" KEYWORDS Full
        "LEN(string)" "How many characters a string has." "10 PRINT LEN(\"MC-600\")";
    Let "LET" "statement" KEYWORDS Full
        "[LET] variable = value" "Stores a value." "10 LET D=12: E=D+1: PRINT D;E";
    List "LIST" "command" KEYWORDS Full
        "LIST [first][-[last]]" "Shows the program, or one line or a range of it." "LIST 150-1000";
    Load "LOAD" "command" KEYWORDS Full
        "LOAD \"name\"" "Replaces the program by a file's." "LOAD \"B:TEST2.BAS\"";
    Log "LOG" "function" KEYWORDS Full
        "LOG(number)" "Natural logarithm." "25 PRINT LOG(45/7)";
    Mcam "MCAM" "motion" MOTION Full
        "MCAM(table%)" "Follows a cam table as function of the master, after bringing speed and phase up to it." "10 MCAM(T%)";
    Mcamend "MCAMEND" "motion" MOTION Full
        "MCAMEND()" "Leaves the cam at the end of the present modulus." "10 MCAMEND()";
    Mcamhard "MCAMHARD" "motion" MOTION Full
        "MCAMHARD(table%)" "Follows a cam table at once." "10 MCAMHARD(T%)";
    Mcanrx "MCANRX" "motion" SERVOBUS Full
        "MCANRX(box,identifier)" "Sets a mailbox, 0 to 7, to receive telegrams of an identifier." "10 MCANRX(0,100)";
    Mcantx "MCANTX" "motion" SERVOBUS Full
        "MCANTX(identifier,data)" "Sends a telegram; identifiers are 1 to 2047." "10 MCANTX(100,X%)";
    Mclrfault "MCLRFAULT" "drive" DRIVE Full
        "MCLRFAULT()" "Clears the drive's fault." "10 MCLRFAULT()";
    Mdrvdis "MDRVDIS" "drive" DRIVE Full
        "MDRVDIS()" "Disables the drive." "10 MDRVDIS()";
    Mdrven "MDRVEN" "drive" DRIVE Full
        "MDRVEN()" "Enables the drive." "10 MDRVEN()";
    Merge "MERGE" "command" KEYWORDS Full
        "MERGE \"name\"" "Adds a file's lines to the program; those of the same number are replaced." "MERGE \"B:TEST2.BAS\"";
    Mgear "MGEAR" "motion" MOTION Full
        "MGEAR(type)" "Follows the master at a ratio; types 1 to 8 say when and how it engages." "10 MGEAR(1)";
    Mhome "MHOME" "motion" MOTION Full
        "MHOME(command)" "Starts (1) or aborts (2) the drive's homing." "10 MHOME(1)";
    MidS "MID$" "function" KEYWORDS Full
        "MID$(string,start[,count])" "Characters from the middle of a string, the first being 1." "10 PRINT MID$(\"MORNING EVENING\",9,4)";
    Midle "MIDLE" "motion" MOTION Full
        "MIDLE()" "Leaves the active generator and stops the axis." "10 MIDLE()";
    Mimerge "MIMERGE" "motion" MOTION Full
        "MIMERGE(distance)" "MMERGE to a place relative to the last target." "10 MIMERGE(4096)";
    Mimove "MIMOVE" "motion" MOTION Full
        "MIMOVE(distance)" "Moves on from the last target by a distance in counts." "10 MIMOVE(4096)";
    Mmerge "MMERGE" "motion" MOTION Full
        "MMERGE(position)" "Moves to a position at the speed that the axis has now." "10 MMERGE(100000)";
    Mmove "MMOVE" "motion" MOTION Full
        "MMOVE(position)" "Moves to a position in counts." "20 MMOVE(40960)";
    Mod "MOD" "function" KEYWORDS Full
        "MOD(a,b)" "Remainder of the division of two integers." "25 PRINT MOD(9,2)";
    Mphase "MPHASE" "motion" MOTION Full
        "MPHASE(position)" "Moves an offset that is added to the active generator's position." "10 MPHASE(1000)";
    Mquotecmp "MQUOTECMP" "motion" INTERRUPTS Full
        "MQUOTECMP(source,comparator,on,off)" "Sets the range in which a position comparator, 0 to 7, is on." "10 MQUOTECMP(0,1,1000,2000)";
    Msetincap "MSETINCAP" "io" IO Full
        "MSETINCAP(input,edge,time)" "Captures the position at an edge of input 2 (0) or 3 (1)." "10 MSETINCAP(0,1,0)";
    Msetoutcmp "MSETOUTCMP" "io" IO Full
        "MSETOUTCMP(on,off)" "Drives output 7 by the motor's position." "10 MSETOUTCMP(1000,2000)";
    Msetsb "MSETSB" "motion" SERVOBUS Full
        "MSETSB(mode)" "Makes the card the bus's master (1) or a slave (0)." "10 MSETSB(1)";
    Mspeed "MSPEED" "motion" MOTION Full
        "MSPEED(speed)" "Turns at a speed in counts*256/sample, reached at SM_ACC%." "10 MSPEED(34952)";
    Mspline "MSPLINE" "motion" MOTION Full
        "MSPLINE(xy%,last,table%)" "Fills a cam table of 360 entries with a cubic spline through pairs of points." "10 MSPLINE(XY%,7,T%)";
    Mvirtualax "MVIRTUALAX" "motion" MOTION Full
        "MVIRTUALAX(position)" "Moves the virtual axis that is added to the master." "10 MVIRTUALAX(40960)";
    Mvspeed "MVSPEED" "motion" MOTION Full
        "MVSPEED(speed)" "Turns the virtual axis that is added to the master." "10 MVSPEED(34952)";
    New "NEW" "command" KEYWORDS Full
        "NEW" "Forgets the program and all variables." "NEW";
    Next "NEXT" "statement" KEYWORDS Full
        "NEXT [variable,...]" "Ends the innermost FOR loop, or those named, inner first." "10 FOR J=1 TO 2: FOR K=5 TO 6: PRINT J;K,: NEXT K,J";
    Not "NOT" "operator" KEYWORDS Full
        "NOT a" "All 32 bits turned over; so also: not true." "10 PRINT NOT 96;NOT 5>3";
    On "ON" "statement" KEYWORDS Full
        "ON number GOTO|GOSUB line,..." "Goes to the line that stands at that place of the list; beyond it, goes on." "10 ON 2 GOTO 20,30\n20 PRINT \"FIRST\": END\n30 PRINT \"SECOND\"";
    Open "OPEN" "not-implemented" KEYWORDS ABSENT
        "handle% = OPEN \"name\"" "Would open a file." "10 F% = OPEN \"MATRIX.TXT\"";
    Or "OR" "operator" KEYWORDS Full
        "a OR b" "Bits set in either, of 32; so also: one of them true." "10 PRINT 64 OR 32;5<3 OR 2>1";
    Outsta "OUTSTA" "io" IO Full
        "OUTSTA()" "The card's eight digital outputs, output 0 in bit 0." "10 PRINT OUTSTA()";
    Outw "OUTW" "io" IO Full
        "OUTW(value)" "Sets the card's eight digital outputs, output 0 from bit 0." "10 OUTW(255)";
    Password "PASSWORD" "command" KEYWORDS Full
        "PASSWORD" "Asks for the console's password, then twice for a new one, which the next power-up wants." "PASSWORD";
    Print "PRINT" "statement" KEYWORDS Full
        "PRINT [value][,|;]..." "Prints values: `,` goes to the next zone of ten columns, `;` or nothing stays, at the end also on the line." "10 X=9: PRINT X;\"SQUARED IS\";X*X";
    Read "READ" "statement" KEYWORDS Full
        "READ variable,..." "Takes the next constants from DATA." "10 FOR I=1 TO 3: READ A: PRINT A*A;: NEXT\n20 DATA 2,3,4";
    Rem "REM" "statement" KEYWORDS Full
        "REM [remark]" "A remark; the rest of the line is text." "10 PRINT 5: REM AVERAGE VELOCITY";
    Renum "RENUM" "command" KEYWORDS Full
        "RENUM [start][,increment]" "Numbers the lines anew, and every jump with them; 10, 20, 30 if not told." "RENUM 100,5";
    Restore "RESTORE" "statement" KEYWORDS Full
        "RESTORE" "Lets READ begin again at the first DATA." "10 READ A: RESTORE: READ B: PRINT A;B\n20 DATA 5,6";
    Reti "RETI" "statement" INTERRUPTS Full
        "RETI" "Returns from an interrupt's subroutine and lets its source in again." "1100 RETI";
    Return "RETURN" "statement" KEYWORDS Full
        "RETURN" "Goes back behind the GOSUB." "10 GOSUB 100: GOSUB 100: END\n100 N=N+1: PRINT N;: RETURN";
    RightS "RIGHT$" "function" KEYWORDS Full
        "RIGHT$(string,count)" "The last characters of a string." "10 PRINT RIGHT$(\"MC-600\",3)";
    Rnd "RND" "function" KEYWORDS Full
        "RND(number)" "A random number from 0 to below 1: the next one; by the clock for 0; below 0 begins a series." "10 PRINT INT(6*RND(1))+1";
    Run "RUN" "command" KEYWORDS Full
        "RUN [\"name\"][,line] | RUN line" "Clears the variables and starts the program, or a file's, at its first line or another." "RUN \"FOO.BAS\",500";
    Save "SAVE" "command" KEYWORDS Full
        "SAVE [\"name\"]" "Writes the program to a file, `.BAS` if not told; without a name to the one last used." "SAVE \"TEST\"";
    Sdoerror "SDOERROR" "drive" DRIVE Full
        "SDOERROR()" "Error code of the last SDOREAD or SDOWRITE." "10 PRINT SDOERROR()";
    Sdoread "SDOREAD" "drive" DRIVE Full
        "SDOREAD(object)" "Value of a drive parameter." "10 X% = SDOREAD(&H35C8)";
    Sdowrite "SDOWRITE" "drive" DRIVE Full
        "SDOWRITE(object,value)" "Writes a drive parameter." "10 SDOWRITE(&H3628,5000)";
    Sgn "SGN" "function" KEYWORDS Full
        "SGN(number)" "-1, 0 or 1 by the number's sign." "10 PRINT SGN(-5);SGN(0);SGN(12)";
    Sin "SIN" "function" KEYWORDS Full
        "SIN(angle)" "Sine of an angle in radians." "235 PRINT SIN(1.5)";
    Spc "SPC" "function" KEYWORDS Full
        "SPC(count)" "In PRINT: that many blanks." "10 PRINT \"A\" SPC(5) \"B\"";
    Sqr "SQR" "function" KEYWORDS Full
        "SQR(number)" "Square of the number (not its root: that is SQRT)." "10 PRINT SQR(15)";
    Sqrt "SQRT" "function" KEYWORDS Full
        "SQRT(number)" "Square root." "10 PRINT SQRT(15)";
    Step "STEP" "statement" KEYWORDS Full
        "FOR ... STEP increment" "What a FOR loop adds at each pass, 1 if not told." "10 FOR X=2 TO 8 STEP 2: PRINT X;: NEXT";
    Stop "STOP" "statement" KEYWORDS Full
        "STOP" "Breaks the program and says where; CONT goes on behind it." "10 PRINT \"FIRST\": STOP: PRINT \"AFTER CONT\"";
    StrS "STR$" "function" KEYWORDS Full
        "STR$(number)" "The number's digits, a blank or `-` before them." "10 PRINT LEN(STR$(15));\"*\"+STR$(1.5E4)+\"*\"";
    Tab "TAB" "function" KEYWORDS Full
        "TAB(column)" "In PRINT: blanks up to a column, the first being 0." "10 PRINT \"NAME\" TAB(10) \"SPEED\"";
    Tan "TAN" "function" KEYWORDS Full
        "TAN(angle)" "Tangent of an angle in radians." "10 PRINT TAN(.785398163)";
    Then "THEN" "statement" KEYWORDS Full
        "IF condition THEN line|statements" "What an IF does when its condition is true." "10 A=1: IF A=1 THEN PRINT \"ONE\"";
    To "TO" "statement" KEYWORDS Full
        "FOR variable = start TO limit" "Stands before a FOR loop's last value." "10 FOR L=1 TO 5: PRINT L;: NEXT";
    Val "VAL" "function" KEYWORDS Full
        "VAL(string)" "The number that a string begins with, 0 without one." "20 PRINT VAL(\"12.5 MM\")";
    Wend "WEND" "statement" KEYWORDS Full
        "WEND [condition]" "WHEND, in its other spelling." "10 WHILE N<3: N=N+1: PRINT N;: WEND";
    Whend "WHEND" "statement" KEYWORDS Full
        "WHEND [condition]" "Ends a WHILE loop: back to its WHILE, unless a condition stands here and is true." "10 WHILE: N=N+1: PRINT N;: WHEND N>=3";
    While "WHILE" "statement" KEYWORDS Full
        "WHILE [condition]" "Repeats what stands before its WHEND while the condition is true; without one, always." "10 WHILE N<3: N=N+1: PRINT N;: WHEND";
    Xor "XOR" "operator" KEYWORDS Full
        "a XOR b" "Bits set in one of the two, of 32." "10 PRINT 5 XOR 1";
}
