//! The lines that the manual prints as formats and examples, in its order. Texts in quotes are shortened.

use super::check;

#[test]
fn rules_numbers_and_variables() {
    for (line, expected) in [
        ("10 print \"Hello\"", "print \"Hello\""),
        ("20 end", "end"),
        ("run", "run"),
        ("A$=\"DRIVE ENABLED\"", "A$ := \"DRIVE ENABLED\""),
        ("MTH$=\"JAN\"+A$", "MTH$ := (add \"JAN\" A$)"),
        ("K%=5", "K% := 5"),
        ("CNT%=CNT%+1", "CNT% := (add CNT% 1)"),
        ("FP=12.5", "FP := 12.5r"),
        ("SUM=FP*CNT%", "SUM := (multiply FP CNT%)"),
        ("A(5)=0", "A[5] := 0"),
        ("B(5,6)=0", "B[5,6] := 0"),
        ("PRINT AB^CD", "print (power AB CD)"),
        ("PRINT 3^-2", "print (power 3 (neg 2))"),
        ("PRINT 1 = 5 - 4", "print (equal 1 (subtract 5 4))"),
        ("PRINT \"A\" < \"B\"", "print (less \"A\" \"B\")"),
        (
            "IF A=100 AND B=100 THEN 10",
            "if (and (equal A 100) (equal B 100)) {goto 10}",
        ),
        ("A=96 AND 32: PRINT A", "A := (and 96 32) | print A"),
        ("IF NOT X<Y THEN 30", "if (not (less X Y)) {goto 30}"),
        ("X= NOT 96", "X := (not 96)"),
        (
            "10 A$=\"FILE\": B$=\"NAME\"",
            "A$ := \"FILE\" | B$ := \"NAME\"",
        ),
        (
            "30 RES$=\"NEW \"+A$+B$",
            "RES$ := (add (add \"NEW \" A$) B$)",
        ),
    ] {
        check(line, expected);
    }
}

#[test]
fn keywords_a_to_e() {
    for (line, expected) in [
        ("10 X = ABS (Y)", "X := abs(Y)"),
        (
            "10 IF X = ABS (X) THEN PRINT \"POSITIVE\"",
            "if (equal X abs(X)) {print \"POSITIVE\"}",
        ),
        (
            "50 IF X=7 AND W=3 THEN GOTO 10: REM X",
            "if (and (equal X 7) (equal W 3)) {goto 10 | rem}",
        ),
        (
            "60 IF A AND Q=7 THEN GOTO 10: REM X",
            "if (and A (equal Q 7)) {goto 10 | rem}",
        ),
        (
            "20 X = ATN(J)*180/ {pi} : REM X",
            "X := (divide (multiply atn(J) 180) 3.141592653589793r) | rem",
        ),
        ("10 PRINT ASC(\"Z\")", "print asc(\"Z\")"),
        ("AUTO 100, 25", "auto Some(100) Some(25)"),
        ("20 A$=CHR$(13) : REM X", "A$ := chrs(13) | rem"),
        (
            "50 A=ASC(A$) : A$ = CHR$(A) : REM X",
            "A := asc(A$) | A$ := chrs(A) | rem",
        ),
        ("10 CLOSE FHNDL1%", "absent FCLOSE"),
        ("CONT", "cont"),
        ("10 PI=0:C=1", "PI := 0 | C := 1"),
        (
            "20 PI=PI+4/C-4/(C+2)",
            "PI := (subtract (add PI (divide 4 C)) (divide 4 (add C 2)))",
        ),
        ("40 C=C+4:GOTO 20", "C := (add C 4) | goto 20"),
        (
            "20 X = COS(Y* {pi} /180) : REM X",
            "X := cos((divide (multiply Y 3.141592653589793r) 180)) | rem",
        ),
        ("10 DATA 1,10,5,8", "data \"1\" \"10\" \"5\" \"8\""),
        (
            "20 DATA JOHN,PAUL,GEORGE,RINGO",
            "data \"JOHN\" \"PAUL\" \"GEORGE\" \"RINGO\"",
        ),
        ("30 DATA \"DEAR, YOU\"", "data q\"DEAR, YOU\""),
        ("40 DATA -1.7E-9, 3.33", "data \"-1.7E-9\" \"3.33\""),
        ("DEL 100-", "del 100..65535"),
        ("DEL 100-200, 300", "del 100..200 300..300"),
        ("10 DIM A(100)", "dim A[100]"),
        ("20 DIM Z (5,7), Y(3,4,5)", "dim Z[5,7] Y[3,4,5]"),
        ("30 DIM Y7%(Q)", "dim Y7%[Q]"),
        ("40 DIM PH$(1000)", "dim PH$[1000]"),
        ("50 F(4)=9 : REM X", "F[4] := 9 | rem"),
        ("10 PRINT\"RUN?\"", "print \"RUN?\""),
        ("20 INPUT A$", "input A$"),
        ("30 IF A$ = \"NO\" THEN END", "if (equal A$ \"NO\") {end}"),
        ("999 END", "end"),
        ("ERASE \"A:FIL*.BAS\"", "erase \"A:FIL*.BAS\""),
        ("10 PRINT EXP (1)", "print exp(1)"),
        (
            "20 X = Y*EXP (Z*Q)",
            "X := (multiply Y exp((multiply Z Q)))",
        ),
    ] {
        check(line, expected);
    }
}

#[test]
fn keywords_f_to_l() {
    for (line, expected) in [
        ("FILES \"B:FIL*.BAS\"", "files \"B:FIL*.BAS\""),
        ("130 IF L <= 10 THEN 110", "if (lessequal L 10) {goto 110}"),
        (
            "100 FOR L = 100 TO 0 STEP -1",
            "for L 100 to 0 step (neg 1)",
        ),
        (
            "100 FOR L = PI TO 6* {pi} STEP .01",
            "for L PI to (multiply 6 3.141592653589793r) step 0.01r",
        ),
        ("100 FOR AA = 3 TO 3", "for AA 3 to 3"),
        (
            "10 GET A$: IF A$ = \"\" THEN 10: REM X",
            "absent GET | if (equal A$ \"\") {goto 10 | rem}",
        ),
        ("20 GET A$, B$, C$, D$, E$: REM X", "absent GET | rem"),
        ("GOTO 100", "goto 100"),
        ("10 GO TO 50", "goto 50"),
        ("GOTO", "goto 0"),
        ("100 GOTOXY 50, 10", "absent GOTOXY"),
        ("100 INPUT \"NUMBER\"; N", "input \"NUMBER\" N"),
        ("110 IF N <= 0 GOTO 200", "if (lessequal N 0) {goto 200}"),
        ("120 PRINT \"ROOT=\" SQR(N)", "print \"ROOT=\" sqr(N)"),
        (
            "110 IF RND(1) < .5 THEN X=X+1: GOTO 130",
            "if (less rnd(1) 0.5r) {X := (add X 1) | goto 130}",
        ),
        ("150 PRINT \"TAILS= \" Y", "print \"TAILS= \" Y"),
        ("110 INPUT B, C, D", "input B C D"),
        ("120 PRINT INTSTA()", "print insta()"),
        (
            "120 PRINT INT(99.4343), INT(-12.34)",
            "print int(99.4343r) , int((neg 12.34r))",
        ),
        (
            "20 B$ = LEFT$(A$,6): PRINT B$",
            "B$ := lefts(A$,6) | print B$",
        ),
        (
            "CC$ = \"MC-600\": PRINT LEN(CC$)",
            "CC$ := \"MC-600\" | print len(CC$)",
        ),
        ("10 LET D= 12", "D := 12"),
        ("40 SUM$= E$ + F$", "SUM$ := (add E$ F$)"),
        ("LIST 150-1000", "list 150..1000"),
        ("LOAD \"B:TEST2.BAS\"", "load \"B:TEST2.BAS\""),
        ("25 PRINT LOG(45/7)", "print log((divide 45 7))"),
        (
            "10 NUM=LOG(ARG)/LOG(10)",
            "NUM := (divide log(ARG) log(10))",
        ),
    ] {
        check(line, expected);
    }
}

#[test]
fn keywords_m_to_r() {
    for (line, expected) in [
        ("MERGE \"TEST.BAS\"", "merge \"TEST.BAS\""),
        ("30 PRINT A$ + MID$(B$,8,8)", "print (add A$ mids(B$,8,8))"),
        ("25 PRINT MOD(9, 2)", "print mod(9,2)"),
        ("10 NEW", "new"),
        (
            "10 FOR J=1 TO 5: FOR K=10 TO 20: FOR N=5 TO -5 STEP - 1",
            "for J 1 to 5 | for K 10 to 20 | for N 5 to (neg 5) step (neg 1)",
        ),
        ("20 NEXT N,K,J", "next N K J"),
        ("30 NEXT", "next"),
        (
            "10 IF NOT AA = BB AND NOT(BB = CC) THEN",
            "if (and (not (equal AA BB)) (not (equal BB CC))) {}",
        ),
        ("NN% = NOT 96: PRINT NN%", "NN% := (not 96) | print NN%"),
        (
            "ON -(A=7)-2*(A=3)-3*(A<3)-4*(A>7)GOTO 400,900,1000,100",
            "on (subtract (subtract (subtract (neg (equal A 7)) (multiply 2 (equal A 3))) \
             (multiply 3 (less A 3))) (multiply 4 (greater A 7))) goto 400 900 1000 100",
        ),
        (
            "ON X+3 GOSUB 9000,20,9000",
            "on (add X 3) gosub 9000 20 9000",
        ),
        (
            "500 ON SUM/2 + 1 GOSUB 50,80,20",
            "on (add (divide SUM 2) 1) gosub 50 80 20",
        ),
        ("10 FILE1% = OPEN \"MATRIX.TXT\"", "absent OPEN"),
        (
            "100 IF (AA=BB) OR (XX=20) THEN",
            "if (or (equal AA BB) (equal XX 20)) {}",
        ),
        (
            "230 KK%=64 OR 32: PRINT KK%",
            "KK% := (or 64 32) | print KK%",
        ),
        ("PASSWORD", "password"),
        (
            "10 PRINT -5*X,X-5,X+5,X^5",
            "print (multiply (neg 5) X) , (subtract X 5) , (add X 5) , (power X 5)",
        ),
        (
            "10 PRINT X;\"SQUARED\";X*X;\"AND\";",
            "print X ; \"SQUARED\" ; (multiply X X) ; \"AND\" ;",
        ),
        ("20 PRINT X \"CUBED\" X^3", "print X \"CUBED\" (power X 3)"),
        ("110 READ A,B,C$", "read A B C$"),
        (
            "100 FOR X=1 TO 10: READ A(X):NEXT",
            "for X 1 to 10 | read A[X] | next",
        ),
        ("1 READ CITY$,STATE$,ZIP", "read CITY$ STATE$ ZIP"),
        (
            "5 DATA DENVER,COLORADO, 80211",
            "data \"DENVER\" \"COLORADO\" \"80211\"",
        ),
        ("20 FOR X= 1 TO 20 :REM LOOP", "for X 1 to 20 | rem"),
        (
            "30 SUM=SUM + VEL(X): NEXT",
            "SUM := (add SUM VEL[X]) | next",
        ),
        ("200 RESTORE", "restore"),
        ("1000 PRINT\"GOSUB\":RETURN", "print \"GOSUB\" | return"),
        ("20 PRINT RIGHT$(MSG$,3)", "print rights(MSG$,3)"),
        ("RUN 500", "run at 500"),
        ("RUN X", "run X"),
        ("RUN \"FOO.BAS\"", "run \"FOO.BAS\""),
        ("RUN \"FOO.BAS\",500", "run \"FOO.BAS\" at 500"),
    ] {
        check(line, expected);
    }
}

#[test]
fn keywords_s_to_x() {
    for (line, expected) in [
        ("SAVE \"TEST\"", "save \"TEST\""),
        (
            "90 ON SGN(DV)+2 GOTO 100, 200, 300",
            "on (add sgn(DV) 2) goto 100 200 300",
        ),
        ("235 AA=SIN(1.5):PRINT AA", "AA := sin(1.5r) | print AA"),
        (
            "10 PRINT\"RIGHT \"; \"HERE &\";",
            "print \"RIGHT \" ; \"HERE &\" ;",
        ),
        (
            "20 PRINT SPC(5)\"OVER\" SPC(14)\"THERE\"",
            "print spc(5) \"OVER\" spc(14) \"THERE\"",
        ),
        (
            "FOR J = 2 TO 5: PRINT J*5, SQR(J*5): NEXT",
            "for J 2 to 5 | print (multiply J 5) , sqr((multiply J 5)) | next",
        ),
        ("PRINT SQRT(J*5)", "print sqrt((multiply J 5))"),
        (
            "35 FOR ZZ=0 TO -20 STEP -2",
            "for ZZ 0 to (neg 20) step (neg 2)",
        ),
        ("10 INPUT#1,AA,BB,CC", "absent INPUT"),
        (
            "20 IF AA=BB AND BB=CC THEN STOP",
            "if (and (equal AA BB) (equal BB CC)) {stop}",
        ),
        (
            "100 FLT = 1.5E4: ALPHA$ = STR$(FLT)",
            "FLT := 15000.0r | ALPHA$ := strs(FLT)",
        ),
        (
            "100 PRINT\"NAME\" TAB(25) \"AMOUNT\": PRINT",
            "print \"NAME\" tab(25) \"AMOUNT\" | print",
        ),
        ("120 PRINT NAM$ TAB(25) AMT$", "print NAM$ tab(25) AMT$"),
        ("PRINT TAB (25) SPC (5)", "print tab(25) spc(5)"),
        (
            "10 XX=.785398163: YY=TAN(XX):PRINT YY",
            "XX := 0.785398163r | YY := tan(XX) | print YY",
        ),
        (
            "20 IF VAL(ZIP$) < 19400 OR VAL(ZIP$) > 96699 THEN PRINT NAM$ TAB(25) \"G\"",
            "if (or (less val(ZIP$) 19400) (greater val(ZIP$) 96699)) {print NAM$ tab(25) \"G\"}",
        ),
        ("110 WHILE (M < N)", "while (less M N)"),
        ("110 WHILE", "while"),
        ("140 WHEND", "whend"),
        ("140 WHEND (M < N)", "whend (less M N)"),
        ("WEND M>N", "whend (greater M N)"),
        ("PRINT A XOR B", "print (xor A B)"),
    ] {
        check(line, expected);
    }
}

#[test]
fn motion_drive_and_inputs() {
    for (line, expected) in [
        ("mspeed(vel)", "call MSPEED(VEL)"),
        ("Mmove(pos)", "call MMOVE(POS)"),
        ("mimove(ipos)", "call MIMOVE(IPOS)"),
        ("Midle()", "call MIDLE()"),
        ("midle", "call MIDLE()"),
        ("mclrfault()", "call MCLRFAULT()"),
        ("mdrven()", "call MDRVEN()"),
        ("mdrvdis()", "call MDRVDIS()"),
        ("outw(v)", "call OUTW(V)"),
        ("Mmerge(pos)", "call MMERGE(POS)"),
        ("mgear(type)", "call MGEAR(TYPE)"),
        (
            "mcam(table%): mcamend",
            "call MCAM(TABLE%) | call MCAMEND()",
        ),
        ("Mquotecmp(s,d,o,f)", "call MQUOTECMP(S,D,O,F)"),
        ("Intdisable(): RETI", "call INTDISABLE() | reti"),
        (
            "X=sdoread(idx)+sdoerror()",
            "X := (add sdoread(IDX) sdoerror())",
        ),
        ("X=can_data%(3)", "X := candata(3)"),
        ("PRINT outsta(),insta()", "print outsta() , insta()"),
        ("Gv_smod%=4096", "system GV_SMOD% := 4096"),
        ("mspline(xy%,np%,camtab%)", "call MSPLINE(XY%,NP%,CAMTAB%)"),
        (
            "Intsetup(Line%, Source%, Edge%)",
            "call INTSETUP(LINE%,SOURCE%,EDGE%)",
        ),
        ("Msetincap(in, edge, time)", "call MSETINCAP(IN,EDGE,TIME)"),
        ("sdowrite(idx,d)", "call SDOWRITE(IDX,D)"),
        (
            "PRINT gv_in0% gv_out9%",
            "print system GV_IN0% system GV_OUT9%",
        ),
    ] {
        check(line, expected);
    }
}
