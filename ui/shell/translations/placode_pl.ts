<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pl_PL">
<context>
    <name>Layout</name>
    <message>
        <source>Move up</source>
        <translation>Ruch w górę</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Ruch w dół</translation>
    </message>
    <message>
        <source>Move left</source>
        <translation>Ruch w lewo</translation>
    </message>
    <message>
        <source>Move right</source>
        <translation>Ruch w prawo</translation>
    </message>
    <message>
        <source>Go deeper</source>
        <translation>Głębiej</translation>
    </message>
    <message>
        <source>Come back</source>
        <translation>Z powrotem</translation>
    </message>
    <message>
        <source>Turn to the left</source>
        <translation>Obrót w lewo</translation>
    </message>
    <message>
        <source>Turn to the right</source>
        <translation>Obrót w prawo</translation>
    </message>
    <message>
        <source>Cut, close the jaws</source>
        <translation>Cięcie, zamknięcie szczęk</translation>
    </message>
    <message>
        <source>Coagulate</source>
        <translation>Koagulacja</translation>
    </message>
    <message>
        <source>Precise</source>
        <translation>Precyzyjnie</translation>
    </message>
    <message>
        <source>Mouse turns, wheel goes further</source>
        <translation>Mysz obraca, kółko dalej</translation>
    </message>
    <message>
        <source>Hold the instrument still</source>
        <translation>Narzędzie stoi</translation>
    </message>
    <message>
        <source>Next instrument</source>
        <translation>Następne narzędzie</translation>
    </message>
    <message>
        <source>Scope up</source>
        <translation>Fetoskop w górę</translation>
    </message>
    <message>
        <source>Scope down</source>
        <translation>Fetoskop w dół</translation>
    </message>
    <message>
        <source>Scope left</source>
        <translation>Fetoskop w lewo</translation>
    </message>
    <message>
        <source>Scope right</source>
        <translation>Fetoskop w prawo</translation>
    </message>
    <message>
        <source>Wipe the lens</source>
        <translation>Przetarcie optyki</translation>
    </message>
    <message>
        <source>Sound off, on</source>
        <translation>Dźwięk wył., wł.</translation>
    </message>
</context>
<context>
    <name>ControlsCard</name>
    <message>
        <source>Keys and buttons</source>
        <translation>Klawisze i przyciski</translation>
    </message>
    <message>
        <source>For mouse, keyboard and gamepad, at this computer. The help and the hints name the keys that you choose. Press a key below to change it; Enter, Escape and the function keys always stay.</source>
        <translation>Dla myszy, klawiatury i pada, na tym komputerze. Pomoc i wskazówki podają wybrane klawisze. Naciśnij klawisz poniżej, aby go zmienić; Enter, Escape i klawisze funkcyjne zawsze pozostają.</translation>
    </message>
    <message>
        <source>Exchange the left and right mouse button</source>
        <translation>Zamień lewy i prawy przycisk myszy</translation>
    </message>
    <message>
        <source>Exchange the sticks of the gamepad</source>
        <translation>Zamień gałki pada</translation>
    </message>
    <message>
        <source>Not if the desktop has exchanged them already.</source>
        <translation>Nie, jeśli pulpit już je zamienił.</translation>
    </message>
    <message>
        <source>As delivered</source>
        <translation>Przywróć domyślne</translation>
    </message>
    <message>
        <source>Mouse in the left hand</source>
        <translation>Mysz w lewej ręce</translation>
    </message>
    <message>
        <source>All keys and buttons are as delivered.</source>
        <translation>Wszystkie klawisze i przyciski mają ustawienia domyślne.</translation>
    </message>
    <message>
        <source>The keys are below the right hand now, and the mouse buttons exchanged.</source>
        <translation>Klawisze są teraz pod prawą ręką, a przyciski myszy zamienione.</translation>
    </message>
    <message>
        <source>%1 cannot be chosen. Letters, digits from 3, signs, arrows, the number pad, Space, Tab, Shift, Ctrl and Alt can.</source>
        <translation>%1: nie można wybrać. Można: litery, cyfry od 3, znaki, strzałki, klawiaturę numeryczną, Spację, Tab, Shift, Ctrl i Alt.</translation>
    </message>
    <message>
        <source>This key</source>
        <translation>Ten klawisz</translation>
    </message>
    <message>
        <source>Kept.</source>
        <translation>Zapisano.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>%1, which was there, got %2.</source>
        <translation>%1: teraz %2, bo klawisz był zajęty.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>RetentionCard</name>
    <message numerus="yes">
        <source>Erase the records of %n participant(s)?</source>
        <translation>
            <numerusform>Usunąć zapisy %n uczestnika?</numerusform>
            <numerusform>Usunąć zapisy %n uczestników?</numerusform>
            <numerusform>Usunąć zapisy %n uczestników?</numerusform>
        </translation>
    </message>
    <message>
        <source>Answers, attempts and signatures of %1 are deleted. Codes and arms stay. Export first what is still to be analysed.</source>
        <translation>Odpowiedzi, próby i podpisy (%1) zostaną usunięte. Kody i grupy pozostaną. Najpierw wyeksportuj to, co ma być jeszcze analizowane.</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Erasing records</source>
        <translation>Usuwanie zapisów</translation>
    </message>
    <message numerus="yes">
        <source>The records of %n participant(s) are erased.</source>
        <translation>
            <numerusform>Usunięto zapisy %n uczestnika.</numerusform>
            <numerusform>Usunięto zapisy %n uczestników.</numerusform>
            <numerusform>Usunięto zapisy %n uczestników.</numerusform>
        </translation>
    </message>
    <message>
        <source>How long records are kept</source>
        <translation>Jak długo przechowuje się zapisy</translation>
    </message>
    <message numerus="yes">
        <source>Participants were told: %n year(s) after their last step.</source>
        <translation>
            <numerusform>Uczestnikom powiedziano: %n rok od ich ostatniego kroku.</numerusform>
            <numerusform>Uczestnikom powiedziano: %n lata od ich ostatniego kroku.</numerusform>
            <numerusform>Uczestnikom powiedziano: %n lat od ich ostatniego kroku.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is due before %1 (%2).</source>
        <translation>Nic nie przypada przed %1 (%2).</translation>
    </message>
    <message numerus="yes">
        <source>The time of %n participant(s) is over: %1.</source>
        <translation>
            <numerusform>Minął czas %n uczestnika: %1.</numerusform>
            <numerusform>Minął czas %n uczestników: %1.</numerusform>
            <numerusform>Minął czas %n uczestników: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Erase these records</source>
        <translation>Usuń te zapisy</translation>
    </message>
</context>
<context>
    <name>placode::ui::KeyButton</name>
    <message>
        <source>Press a key…</source>
        <translation>Naciśnij klawisz…</translation>
    </message>
</context>
<context>
    <name>LocalProfileCard</name>
    <message>
        <source>Make an account of this profile</source>
        <translation>Załóż konto dla tego profilu</translation>
    </message>
    <message>
        <source>The profile has no password: whoever uses this computer can open it. With a name and a password it is an account. Your attempts and scores stay yours, and other people can be added.</source>
        <translation>Profil nie ma hasła: może go otworzyć każdy, kto używa tego komputera. Z imieniem i nazwiskiem oraz hasłem staje się kontem. Twoje próby i wyniki pozostają Twoje, a inne osoby można dodać.</translation>
    </message>
    <message>
        <source>Make the account</source>
        <translation>Załóż konto</translation>
    </message>
    <message>
        <source>Making the account</source>
        <translation>Zakładanie konta</translation>
    </message>
    <message>
        <source>The account was made. From now on you sign in with your password.</source>
        <translation>Konto zostało założone. Od teraz logujesz się hasłem.</translation>
    </message>
</context>
<context>
    <name>ServerSetupPage</name>
    <message>
        <source>The centre's server</source>
        <translation>Serwer ośrodka</translation>
    </message>
    <message>
        <source>Type the address of this station. The password is no part of it: it is asked for, or read from ~/.pgpass.</source>
        <translation>Wpisz adres tego stanowiska. Hasło nie jest jego częścią: Placode o nie zapyta albo odczyta je z ~/.pgpass.</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adres</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Połącz</translation>
    </message>
    <message>
        <source>First start</source>
        <translation>Pierwsze uruchomienie</translation>
    </message>
    <message>
        <source>Type the server's address.</source>
        <translation>Wpisz adres serwera.</translation>
    </message>
    <message>
        <source>Found "%1". An address begins with postgresql:// and names the server and the database.</source>
        <translation>Podano „%1”. Adres zaczyna się od postgresql:// oraz podaje serwer i bazę.</translation>
    </message>
    <message>
        <source>Leave the password out: whoever opens the settings could read it. Placode asks for it.</source>
        <translation>Pomiń hasło: mógłby je odczytać każdy, kto otworzy ustawienia. Placode o nie zapyta.</translation>
    </message>
    <message>
        <source>Reading the accounts</source>
        <translation>Odczyt kont</translation>
    </message>
</context>
<context>
    <name>FirstStartPage</name>
    <message>
        <source>Welcome to Placode</source>
        <translation>Witamy w Placode</translation>
    </message>
    <message>
        <source>How will this computer be used?</source>
        <translation>Kto będzie używał tego komputera?</translation>
    </message>
    <message>
        <source>By me alone</source>
        <translation>Tylko ja</translation>
    </message>
    <message>
        <source>No account, no password. You can make an account of it later, and what you have done stays yours.</source>
        <translation>Bez konta i bez hasła. Konto możesz założyć później, a to, co zrobisz, pozostanie Twoje.</translation>
    </message>
    <message>
        <source>Begin the first exercise</source>
        <translation>Zacznij pierwsze ćwiczenie</translation>
    </message>
    <message>
        <source>By several people</source>
        <translation>Kilka osób</translation>
    </message>
    <message>
        <source>Everybody signs in and sees their own attempts. You make the first account, the administrator's, and add the others.</source>
        <translation>Każdy się loguje i widzi własne próby. Zakładasz pierwsze konto, konto administratora, i dodajesz pozostałe osoby.</translation>
    </message>
    <message>
        <source>Set up the station</source>
        <translation>Przygotuj stanowisko</translation>
    </message>
    <message>
        <source>As one station of a centre</source>
        <translation>To jedno ze stanowisk ośrodka</translation>
    </message>
    <message>
        <source>People find their attempts at every station of the centre. You need the address that whoever keeps the server gave you.</source>
        <translation>Każdy znajdzie swoje próby na każdym stanowisku ośrodka. Potrzebny jest adres od osoby, która opiekuje się serwerem.</translation>
    </message>
    <message>
        <source>Connect to the server</source>
        <translation>Połącz z serwerem</translation>
    </message>
    <message>
        <source>First start</source>
        <translation>Pierwsze uruchomienie</translation>
    </message>
    <message>
        <source>Guest</source>
        <translation>Gość</translation>
    </message>
    <message>
        <source>Beginning</source>
        <translation>Rozpoczynanie</translation>
    </message>
    <message>
        <source>Another way to begin</source>
        <translation>Inny sposób rozpoczęcia</translation>
    </message>
</context>
<context>
    <name>AccountFields</name>
    <message>
        <source>A log-in name has no spaces: write it in one, as in anna.nowak.</source>
        <translation>Login nie ma spacji: napisz go razem, na przykład anna.nowak.</translation>
    </message>
    <message>
        <source>at least %1 characters</source>
        <translation>co najmniej %1 znaków</translation>
    </message>
    <message>
        <source>The password is too short: %1 of at least %2 characters.</source>
        <translation>Hasło jest za krótkie: %1 z co najmniej %2 znaków.</translation>
    </message>
    <message>
        <source>for example Anna Nowak</source>
        <translation>na przykład Anna Nowak</translation>
    </message>
    <message>
        <source>short, for signing in</source>
        <translation>krótki, do logowania</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>Imię i nazwisko</translation>
    </message>
    <message>
        <source>Log-in name</source>
        <translation>Login</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Hasło</translation>
    </message>
    <message>
        <source>Password again</source>
        <translation>Powtórz hasło</translation>
    </message>
    <message>
        <source>Give your name and a log-in name.</source>
        <translation>Podaj imię i nazwisko oraz login.</translation>
    </message>
    <message>
        <source>The two passwords differ. Type them again.</source>
        <translation>Hasła się różnią. Wpisz je jeszcze raz.</translation>
    </message>
    <message>
        <source>Type the password once more.</source>
        <translation>Wpisz hasło jeszcze raz.</translation>
    </message>
    <message>
        <source>Fill in: %1.</source>
        <translation>Uzupełnij: %1.</translation>
    </message>
</context>
<context>
    <name>AccountPage</name>
    <message>
        <source>Somebody else set your password and knows it. Choose one that only you know; until then every sign-in begins here.</source>
        <translation>Ktoś inny ustawił Twoje hasło i je zna. Wybierz takie, które znasz tylko Ty; do tego czasu każde logowanie zaczyna się tutaj.</translation>
    </message>
    <message>
        <source>My account</source>
        <translation>Moje konto</translation>
    </message>
    <message>
        <source>Log-in name: %1</source>
        <translation>Login: %1</translation>
    </message>
    <message>
        <source>Roles: %1</source>
        <translation>Role: %1</translation>
    </message>
    <message>
        <source>Since: %1</source>
        <translation>Od: %1</translation>
    </message>
    <message>
        <source>New password</source>
        <translation>Nowe hasło</translation>
    </message>
    <message>
        <source>Present password</source>
        <translation>Obecne hasło</translation>
    </message>
    <message>
        <source>New password again</source>
        <translation>Powtórz nowe hasło</translation>
    </message>
    <message>
        <source>Change the password</source>
        <translation>Zmień hasło</translation>
    </message>
    <message>
        <source>The two passwords differ. Type them again.</source>
        <translation>Hasła się różnią. Wpisz je jeszcze raz.</translation>
    </message>
    <message>
        <source>Changing the password</source>
        <translation>Zmiana hasła</translation>
    </message>
    <message>
        <source>Too many wrong passwords. Try again in %1 s.</source>
        <translation>Zbyt wiele błędnych haseł. Spróbuj ponownie za %1 s.</translation>
    </message>
    <message>
        <source>The present password is wrong.</source>
        <translation>Obecne hasło jest błędne.</translation>
    </message>
    <message>
        <source>The password was changed.</source>
        <translation>Hasło zostało zmienione.</translation>
    </message>
    <message>
        <source>PIN for a quick return</source>
        <translation>PIN do szybkiego powrotu</translation>
    </message>
    <message>
        <source>At a station where you signed in with your password within the last %1 hours, the PIN is enough to come back. Four to twelve digits; after three wrong ones the password is needed.</source>
        <translation>Na stanowisku, na którym w ciągu ostatnich %1 godzin zalogowano się hasłem, do powrotu wystarczy PIN. Od czterech do dwunastu cyfr; po trzech błędnych potrzebne jest hasło.</translation>
    </message>
    <message>
        <source>New PIN</source>
        <translation>Nowy PIN</translation>
    </message>
    <message>
        <source>Set the PIN</source>
        <translation>Ustaw PIN</translation>
    </message>
    <message>
        <source>Remove the PIN</source>
        <translation>Usuń PIN</translation>
    </message>
    <message>
        <source>Setting the PIN</source>
        <translation>Ustawianie kodu PIN</translation>
    </message>
    <message>
        <source>Type four to twelve digits.</source>
        <translation>Wpisz od czterech do dwunastu cyfr.</translation>
    </message>
    <message>
        <source>The PIN is gone.</source>
        <translation>PIN został usunięty.</translation>
    </message>
    <message>
        <source>The PIN is set.</source>
        <translation>PIN jest ustawiony.</translation>
    </message>
    <message>
        <source>My data</source>
        <translation>Moje dane</translation>
    </message>
    <message>
        <source>Everything that is kept about you, as a file that any program can read: account, groups, courses, certificates, attempts with metrics, reasons and remarks.</source>
        <translation>Wszystko, co jest o Tobie przechowywane, jako plik czytelny dla każdego programu: konto, grupy, kursy, certyfikaty, próby z miarami, uzasadnieniami i uwagami.</translation>
    </message>
    <message>
        <source>With the recordings of all attempts</source>
        <translation>Z nagraniami wszystkich prób</translation>
    </message>
    <message>
        <source>Save my data</source>
        <translation>Zapisz moje dane</translation>
    </message>
    <message>
        <source>Saving my data</source>
        <translation>Zapisywanie moich danych</translation>
    </message>
    <message>
        <source>Your data is in %1: attempts %2, recordings %3.</source>
        <translation>Twoje dane są w %1: próby %2, nagrania %3.</translation>
    </message>
    <message>
        <source>Erase me</source>
        <translation>Usuń mnie</translation>
    </message>
    <message>
        <source>Reason, if you like</source>
        <translation>Powód, jeśli chcesz</translation>
    </message>
    <message>
        <source>Ask to be erased</source>
        <translation>Poproś o usunięcie</translation>
    </message>
    <message>
        <source>An administrator then removes your name, log-in, groups and certificates. Save your data before.</source>
        <translation>Administrator usunie wtedy imię i nazwisko, login, grupy i certyfikaty. Najpierw zapisz swoje dane.</translation>
    </message>
    <message>
        <source>You asked on %1. An administrator carries it out.</source>
        <translation>Prośba z %1. Wykona ją administrator.</translation>
    </message>
    <message>
        <source>Ask to be erased?</source>
        <translation>Poprosić o usunięcie?</translation>
    </message>
    <message>
        <source>Once an administrator has done it, it cannot be undone.</source>
        <translation>Gdy administrator to wykona, nie będzie można tego cofnąć.</translation>
    </message>
    <message>
        <source>Asking to be erased</source>
        <translation>Prośba o usunięcie</translation>
    </message>
</context>
<context>
    <name>AttemptsPage</name>
    <message>
        <source>Report of this person</source>
        <translation>Raport tej osoby</translation>
    </message>
    <message>
        <source>Choose a person first.</source>
        <translation>Najpierw wybierz osobę.</translation>
    </message>
    <message>
        <source>Attempts of all trainees</source>
        <translation>Próby wszystkich uczestników szkolenia</translation>
    </message>
    <message>
        <source>Enter or double click opens the result.</source>
        <translation>Enter lub dwukrotne kliknięcie otwiera wynik.</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Próby</translation>
    </message>
    <message>
        <source>Everybody</source>
        <translation>Wszyscy</translation>
    </message>
    <message>
        <source>All tasks</source>
        <translation>Wszystkie zadania</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Osoba</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Zadanie</translation>
    </message>
    <message>
        <source>Reading the attempts</source>
        <translation>Odczyt prób</translation>
    </message>
    <message>
        <source>Nobody has made an attempt yet. Once a trainee has, it shows up here.</source>
        <translation>Nikt jeszcze nie wykonał próby. Pierwsza pojawi się tutaj.</translation>
    </message>
    <message>
        <source>Newer</source>
        <translation>Nowsze</translation>
    </message>
    <message>
        <source>Older</source>
        <translation>Starsze</translation>
    </message>
    <message>
        <source>There is no such attempt.</source>
        <translation>Nie ma takiej próby.</translation>
    </message>
    <message>
        <source>Shown: %1 to %2 of %3</source>
        <translation>Pokazano: %1 do %2 z %3</translation>
    </message>
</context>
<context>
    <name>AttemptsTable</name>
    <message>
        <source>practice, not verified: %1</source>
        <translation>ćwiczenie, niezweryfikowane: %1</translation>
    </message>
    <message>
        <source>still to be simulated again: %1</source>
        <translation>czekają na ponowną symulację: %1</translation>
    </message>
    <message>
        <source>The result of each says what is in doubt.</source>
        <translation>Wynik każdej z nich mówi, co jest wątpliwe.</translation>
    </message>
    <message>
        <source>Placode simulates them by itself: come back later.</source>
        <translation>Placode symuluje je samodzielnie: wróć tu później.</translation>
    </message>
    <message>
        <source>waiting for another version of Placode or processor: %1</source>
        <translation>czekające na inną wersję Placode lub inny procesor: %1</translation>
    </message>
    <message>
        <source>The result of each says which one it waits for.</source>
        <translation>Wynik każdej mówi, na którą czeka.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Rodzaj</translation>
    </message>
    <message>
        <source>Exam</source>
        <translation>Egzamin</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Badanie</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Ćwiczenie</translation>
    </message>
    <message>
        <source>Study %1, participant %2</source>
        <translation>Badanie %1, uczestnik %2</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Kiedy</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Osoba</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Zadanie</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkty</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Zaliczenie</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Czas</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Urządzenie</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Uwaga</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Próby</translation>
    </message>
    <message>
        <source>DEMONSTRATION</source>
        <translation>DEMONSTRACJA</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Niezaliczone</translation>
    </message>
    <message>
        <source>There is no score to show: no attempt at this task counts yet (%1).</source>
        <translation>Nie ma wyniku do pokazania: żadna próba tego zadania jeszcze się nie liczy (%1).</translation>
    </message>
    <message>
        <source>nothing was done: %1</source>
        <translation>nic nie zrobiono: %1</translation>
    </message>
    <message>
        <source>broken off: %1</source>
        <translation>przerwano: %1</translation>
    </message>
    <message>
        <source>Begin the first step of the task and go on as far as you can.</source>
        <translation>Zacznij pierwszy krok zadania i wykonaj tyle, ile potrafisz.</translation>
    </message>
    <message>
        <source>Let an attempt come to its end, or hold Enter to end it.</source>
        <translation>Pozwól próbie dojść do końca albo przytrzymaj Enter, aby ją zakończyć.</translation>
    </message>
    <message>
        <source>On a computer that is too slow close other programs, or use another one.</source>
        <translation>Na zbyt wolnym komputerze zamknij inne programy albo użyj innego.</translation>
    </message>
    <message>
        <source>computer too slow or device at fault: %1</source>
        <translation>komputer za wolny lub wadliwe urządzenie: %1</translation>
    </message>
    <message>
        <source>tuned: %1</source>
        <translation>strojone: %1</translation>
    </message>
    <message>
        <source>Leave the tuning panel (F2) closed.</source>
        <translation>Nie otwieraj panelu strojenia (F2).</translation>
    </message>
    <message>
        <source>begun at a stage: %1</source>
        <translation>rozpoczęte od etapu: %1</translation>
    </message>
    <message>
        <source>Begin at the beginning for an attempt that counts.</source>
        <translation>Aby próba się liczyła, zacznij od początku.</translation>
    </message>
    <message>
        <source>There are attempts, but none of them counts (%1).</source>
        <translation>Są próby, ale żadna się nie liczy (%1).</translation>
    </message>
</context>
<context>
    <name>AuditPage</name>
    <message>
        <source>Audit</source>
        <translation>Dziennik</translation>
    </message>
    <message>
        <source>Find in the list</source>
        <translation>Szukaj na liście</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Kiedy</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Kto</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Co</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Czego dotyczy</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Szczegóły</translation>
    </message>
    <message>
        <source>Shown: %1 of %2</source>
        <translation>Pokazano: %1 z %2</translation>
    </message>
    <message>
        <source>nobody signed in</source>
        <translation>nikt niezalogowany</translation>
    </message>
    <message>
        <source>command line (%1)</source>
        <translation>wiersz poleceń (%1)</translation>
    </message>
</context>
<context>
    <name>AuditWords</name>
    <message>
        <source>came in without a password</source>
        <translation>wejście bez hasła</translation>
    </message>
    <message>
        <source>made an account of the local profile</source>
        <translation>założono konto dla profilu lokalnego</translation>
    </message>
    <message>
        <source>sent scores to a learning platform</source>
        <translation>wysłano wyniki do platformy edukacyjnej</translation>
    </message>
    <message>
        <source>linked a person with a learning platform</source>
        <translation>powiązano osobę z platformą edukacyjną</translation>
    </message>
    <message>
        <source>took back a link with a learning platform</source>
        <translation>cofnięto powiązanie z platformą edukacyjną</translation>
    </message>
    <message>
        <source>sent statements to a learning record store</source>
        <translation>wysłano zdania do repozytorium danych o uczeniu się</translation>
    </message>
    <message>
        <source>took recordings out for a batch</source>
        <translation>pobrano nagrania do przetwarzania wsadowego</translation>
    </message>
    <message>
        <source>queued a batch for idle stations</source>
        <translation>przekazano zadanie wsadowe wolnym stanowiskom</translation>
    </message>
    <message>
        <source>took a batch out of the queue</source>
        <translation>usunięto zadanie wsadowe z kolejki</translation>
    </message>
    <message>
        <source>trusted a station</source>
        <translation>uznano stanowisko za zaufane</translation>
    </message>
    <message>
        <source>sealed what was there</source>
        <translation>opieczętowano zastane dane</translation>
    </message>
    <message>
        <source>simulated an attempt again, with the same outcome</source>
        <translation>zasymulowano próbę ponownie, z tym samym wynikiem</translation>
    </message>
    <message>
        <source>simulated an attempt again, with another outcome</source>
        <translation>zasymulowano próbę ponownie, z innym wynikiem</translation>
    </message>
    <message>
        <source>put an attempt back to be simulated again</source>
        <translation>skierowano próbę do ponownej symulacji</translation>
    </message>
    <message>
        <source>copied a recovered recording elsewhere</source>
        <translation>skopiowano odzyskane nagranie w inne miejsce</translation>
    </message>
    <message>
        <source>published a task</source>
        <translation>opublikowano zadanie</translation>
    </message>
    <message>
        <source>changed the roles of a person</source>
        <translation>zmieniono role osoby</translation>
    </message>
    <message>
        <source>imported an attempt</source>
        <translation>zaimportowano próbę</translation>
    </message>
    <message>
        <source>scored an attempt again</source>
        <translation>ponownie oceniono próbę</translation>
    </message>
    <message>
        <source>saved an attempt</source>
        <translation>zapisano próbę</translation>
    </message>
    <message>
        <source>declared an attempt void</source>
        <translation>unieważniono próbę</translation>
    </message>
    <message>
        <source>wrote a comment</source>
        <translation>dodano komentarz</translation>
    </message>
    <message>
        <source>removed a comment</source>
        <translation>usunięto komentarz</translation>
    </message>
    <message>
        <source>brought a comment back</source>
        <translation>przywrócono komentarz</translation>
    </message>
    <message>
        <source>sealed a consent form</source>
        <translation>opieczętowano formularz zgody</translation>
    </message>
    <message>
        <source>assigned a course</source>
        <translation>przydzielono kurs</translation>
    </message>
    <message>
        <source>issued a certificate</source>
        <translation>wystawiono certyfikat</translation>
    </message>
    <message>
        <source>granted more attempts</source>
        <translation>przyznano dodatkowe próby</translation>
    </message>
    <message>
        <source>published a course</source>
        <translation>opublikowano kurs</translation>
    </message>
    <message>
        <source>took a course back</source>
        <translation>cofnięto przydział kursu</translation>
    </message>
    <message>
        <source>began an exam</source>
        <translation>rozpoczęto egzamin</translation>
    </message>
    <message>
        <source>exported a cohort</source>
        <translation>wyeksportowano dane grupy</translation>
    </message>
    <message>
        <source>made a group</source>
        <translation>utworzono grupę</translation>
    </message>
    <message>
        <source>changed who is in a group</source>
        <translation>zmieniono skład grupy</translation>
    </message>
    <message>
        <source>exported a norm pack</source>
        <translation>wyeksportowano pakiet norm</translation>
    </message>
    <message>
        <source>took in a norm pack</source>
        <translation>przyjęto pakiet norm</translation>
    </message>
    <message>
        <source>made the centre's signing key</source>
        <translation>utworzono klucz podpisu ośrodka</translation>
    </message>
    <message>
        <source>trusted another centre's key</source>
        <translation>zaufano kluczowi innego ośrodka</translation>
    </message>
    <message>
        <source>put a norm pack to use</source>
        <translation>zastosowano pakiet norm</translation>
    </message>
    <message>
        <source>published a questionnaire</source>
        <translation>opublikowano kwestionariusz</translation>
    </message>
    <message>
        <source>rated an attempt</source>
        <translation>oceniono próbę (ocena eksperta)</translation>
    </message>
    <message>
        <source>deleted a recovered recording</source>
        <translation>usunięto odzyskane nagranie</translation>
    </message>
    <message>
        <source>wrote a certificate</source>
        <translation>utworzono certyfikat</translation>
    </message>
    <message>
        <source>wrote the seal of an attempt</source>
        <translation>utworzono pieczęć próby</translation>
    </message>
    <message>
        <source>wrote a cohort's report</source>
        <translation>utworzono raport grupy</translation>
    </message>
    <message>
        <source>wrote a study's figures</source>
        <translation>zapisano wykresy badania</translation>
    </message>
    <message>
        <source>wrote an attempt's report</source>
        <translation>utworzono raport próby</translation>
    </message>
    <message>
        <source>wrote a study's report</source>
        <translation>utworzono raport badania</translation>
    </message>
    <message>
        <source>wrote a trainee's report</source>
        <translation>utworzono raport szkolącego się</translation>
    </message>
    <message>
        <source>published a rubric</source>
        <translation>opublikowano kryteria oceny</translation>
    </message>
    <message>
        <source>locked the station</source>
        <translation>zablokowano stanowisko</translation>
    </message>
    <message>
        <source>signed in</source>
        <translation>zalogowano się</translation>
    </message>
    <message>
        <source>tried to sign in to a deactivated account</source>
        <translation>próba logowania na wyłączone konto</translation>
    </message>
    <message>
        <source>came back with the PIN</source>
        <translation>powrót po podaniu PIN</translation>
    </message>
    <message>
        <source>tried to sign in with a log-in that nobody has</source>
        <translation>próba logowania na nieistniejący login</translation>
    </message>
    <message>
        <source>wrong password</source>
        <translation>błędne hasło</translation>
    </message>
    <message>
        <source>wrong PIN</source>
        <translation>błędny PIN</translation>
    </message>
    <message>
        <source>set a pass mark</source>
        <translation>ustalono próg zaliczenia</translation>
    </message>
    <message>
        <source>saved the station's devices</source>
        <translation>zapisano urządzenia stanowiska</translation>
    </message>
    <message>
        <source>switched the daily backup on</source>
        <translation>włączono codzienną kopię</translation>
    </message>
    <message>
        <source>proctor %1</source>
        <translation>nadzór %1</translation>
    </message>
    <message>
        <source>switched the daily backup off</source>
        <translation>wyłączono codzienną kopię</translation>
    </message>
    <message>
        <source>made a backup</source>
        <translation>utworzono kopię zapasową</translation>
    </message>
    <message>
        <source>moved the store</source>
        <translation>przeniesiono bazę</translation>
    </message>
    <message>
        <source>restored a backup</source>
        <translation>przywrócono kopię zapasową</translation>
    </message>
    <message>
        <source>erased nobody on the word of an entry that is not proved</source>
        <translation>nikogo nie usunięto na podstawie wpisu bez dowodu</translation>
    </message>
    <message>
        <source>saved a questionnaire's answers</source>
        <translation>zapisano odpowiedzi kwestionariusza</translation>
    </message>
    <message>
        <source>saved a signed consent</source>
        <translation>zapisano podpisaną zgodę</translation>
    </message>
    <message>
        <source>looked at a consent's signature</source>
        <translation>obejrzano podpis pod zgodą</translation>
    </message>
    <message>
        <source>corrected an answer</source>
        <translation>poprawiono odpowiedź</translation>
    </message>
    <message>
        <source>made a study's key of names</source>
        <translation>utworzono klucz nazwisk badania</translation>
    </message>
    <message>
        <source>named a participant in the key</source>
        <translation>wpisano nazwisko uczestnika do klucza</translation>
    </message>
    <message>
        <source>opened a study's key of names</source>
        <translation>otwarto klucz nazwisk badania</translation>
    </message>
    <message>
        <source>took in a participant</source>
        <translation>włączono uczestnika</translation>
    </message>
    <message>
        <source>published a protocol</source>
        <translation>opublikowano protokół</translation>
    </message>
    <message>
        <source>locked a participant's record</source>
        <translation>zablokowano rekord uczestnika</translation>
    </message>
    <message>
        <source>signed a participant's record</source>
        <translation>podpisano rekord uczestnika</translation>
    </message>
    <message>
        <source>unlocked a participant's record</source>
        <translation>odblokowano rekord uczestnika</translation>
    </message>
    <message>
        <source>entered a questionnaire a second time</source>
        <translation>wprowadzono kwestionariusz po raz drugi</translation>
    </message>
    <message>
        <source>went through a step of a protocol</source>
        <translation>wykonano krok protokołu</translation>
    </message>
    <message>
        <source>withdrew a participant</source>
        <translation>wycofano uczestnika</translation>
    </message>
    <message>
        <source>activated an account</source>
        <translation>włączono konto</translation>
    </message>
    <message>
        <source>asked for erasure</source>
        <translation>poproszono o usunięcie danych</translation>
    </message>
    <message>
        <source>created an account</source>
        <translation>utworzono konto</translation>
    </message>
    <message>
        <source>took a copy of the own data</source>
        <translation>pobrano kopię własnych danych</translation>
    </message>
    <message>
        <source>deactivated an account</source>
        <translation>wyłączono konto</translation>
    </message>
    <message>
        <source>erased a person</source>
        <translation>usunięto dane osoby</translation>
    </message>
    <message>
        <source>invited somebody</source>
        <translation>zaproszono osobę</translation>
    </message>
    <message>
        <source>followed an invitation</source>
        <translation>skorzystano z zaproszenia</translation>
    </message>
    <message>
        <source>changed a password</source>
        <translation>zmieniono hasło</translation>
    </message>
    <message>
        <source>set a PIN</source>
        <translation>ustawiono PIN</translation>
    </message>
    <message>
        <source>removed the PIN</source>
        <translation>usunięto PIN</translation>
    </message>
    <message>
        <source>exported a study as %1</source>
        <translation>wyeksportowano badanie jako %1</translation>
    </message>
    <message>
        <source>wrote the analysis %1</source>
        <translation>zapisano analizę %1</translation>
    </message>
    <message>
        <source>used a study's key of names: %1</source>
        <translation>użyto klucza nazwisk badania: %1</translation>
    </message>
    <message>
        <source>assignment %1</source>
        <translation>przydział %1</translation>
    </message>
    <message>
        <source>attempt %1</source>
        <translation>próba %1</translation>
    </message>
    <message>
        <source>comment %1</source>
        <translation>komentarz %1</translation>
    </message>
    <message>
        <source>group %1</source>
        <translation>grupa %1</translation>
    </message>
    <message>
        <source>invitation %1</source>
        <translation>zaproszenie %1</translation>
    </message>
    <message>
        <source>norm pack %1</source>
        <translation>pakiet norm %1</translation>
    </message>
    <message>
        <source>person %1</source>
        <translation>osoba %1</translation>
    </message>
    <message>
        <source>attempts stay without a name</source>
        <translation>próby zostają bez nazwiska</translation>
    </message>
    <message>
        <source>everybody</source>
        <translation>wszyscy</translation>
    </message>
    <message>
        <source>educator</source>
        <translation>instruktor</translation>
    </message>
    <message>
        <source>member</source>
        <translation>członek</translation>
    </message>
    <message>
        <source>not in the group any more</source>
        <translation>już poza grupą</translation>
    </message>
    <message>
        <source>with attempts</source>
        <translation>razem z próbami</translation>
    </message>
    <message>
        <source>%1, version %2</source>
        <translation>%1, wersja %2</translation>
    </message>
    <message>
        <source>took the screen back from a participant</source>
        <translation>odebrano ekran uczestnikowi</translation>
    </message>
    <message>
        <source>chose a participant's device</source>
        <translation>wybrano urządzenie uczestnika</translation>
    </message>
    <message>
        <source>noted something on a step</source>
        <translation>zapisano uwagę do kroku</translation>
    </message>
    <message>
        <source>had a procedure done again</source>
        <translation>zarządzono powtórzenie zabiegu</translation>
    </message>
    <message>
        <source>exported the centre&apos;s sealed key</source>
        <translation>wyeksportowano zabezpieczony klucz ośrodka</translation>
    </message>
    <message>
        <source>took in a key of the centre</source>
        <translation>przyjęto klucz ośrodka</translation>
    </message>
    <message>
        <source>changed the passphrase of the centre&apos;s key</source>
        <translation>zmieniono hasło klucza ośrodka</translation>
    </message>
    <message>
        <source>made a new key of the centre</source>
        <translation>utworzono nowy klucz ośrodka</translation>
    </message>
    <message>
        <source>put the centre&apos;s key under a passphrase</source>
        <translation>zabezpieczono klucz ośrodka hasłem</translation>
    </message>
    <message>
        <source>erased records that had been kept long enough</source>
        <translation>usunięto zapisy, które przechowywano wystarczająco długo</translation>
    </message>
    <message>
        <source>set an entry aside that does not fit</source>
        <translation>odłożono wpis, który nie pasuje</translation>
    </message>
    <message>
        <source>said why an entry was set aside</source>
        <translation>podano, dlaczego odłożono wpis</translation>
    </message>
</context>
<context>
    <name>CohortPage</name>
    <message>
        <source>Whoever made attempts has left: the accounts are deactivated.</source>
        <translation>Wszyscy, którzy mają próby, odeszli: ich konta są wyłączone.</translation>
    </message>
    <message>
        <source>Cohort</source>
        <translation>Postępy</translation>
    </message>
    <message>
        <source>Only people who need help</source>
        <translation>Tylko potrzebujący pomocy</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Eksport</translation>
    </message>
    <message>
        <source>Nobody has made an attempt yet. Once a trainee has, it shows up here.</source>
        <translation>Nikt nie wykonał jeszcze próby. Gdy to nastąpi, pojawi się tutaj.</translation>
    </message>
    <message>
        <source>not tried</source>
        <translation>bez prób</translation>
    </message>
    <message>
        <source>learning</source>
        <translation>uczy się</translation>
    </message>
    <message>
        <source>passing</source>
        <translation>zalicza</translation>
    </message>
    <message>
        <source>regressed</source>
        <translation>regres</translation>
    </message>
    <message>
        <source>stuck</source>
        <translation>zastój</translation>
    </message>
    <message>
        <source>Who needs help</source>
        <translation>Kto potrzebuje pomocy</translation>
    </message>
    <message>
        <source>Nobody is stuck or regressed.</source>
        <translation>Nikt nie utknął ani się nie cofnął.</translation>
    </message>
    <message>
        <source>Stuck: none of the last 5 attempts passed and no gain of 3 points. Regressed: passed before, but neither of the last two attempts.</source>
        <translation>Zastój: żadnej z ostatnich 5 prób nie zaliczono i wynik nie wzrósł o 3 punkty. Regres: wcześniej zaliczano, ale żadnej z ostatnich dwóch prób nie zaliczono.</translation>
    </message>
    <message>
        <source>%1 · %2 · last %3, best %4, attempts %5</source>
        <translation>%1 · %2 · ostatnio %3, najlepiej %4, prób %5</translation>
    </message>
    <message>
        <source>Open the attempts</source>
        <translation>Otwórz próby</translation>
    </message>
    <message>
        <source>Open the attempts of %1</source>
        <translation>Otwórz próby: %1</translation>
    </message>
    <message>
        <source>People by tasks</source>
        <translation>Osoby i zadania</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Osoba</translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation>Ostatnio</translation>
    </message>
    <message>
        <source>best %1, finished attempts passed in a row: %2</source>
        <translation>najlepiej %1, ukończone próby zaliczone z rzędu: %2</translation>
    </message>
    <message>
        <source>Scores of a task</source>
        <translation>Wyniki zadania</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Zadanie</translation>
    </message>
    <message>
        <source>Every point is a person; box: quartiles, line: median, diamond: mean.</source>
        <translation>Każdy punkt to osoba; prostokąt: kwartyle, linia: mediana, romb: średnia.</translation>
    </message>
    <message>
        <source>first attempt</source>
        <translation>pierwsza próba</translation>
    </message>
    <message>
        <source>last attempt</source>
        <translation>ostatnia próba</translation>
    </message>
    <message>
        <source>best attempt</source>
        <translation>najlepsza próba</translation>
    </message>
    <message>
        <source>score [points of 100]</source>
        <translation>wynik [punkty na 100]</translation>
    </message>
    <message>
        <source>Export the cohort</source>
        <translation>Eksport grupy</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Exporting the cohort</source>
        <translation>Eksportowanie grupy</translation>
    </message>
    <message>
        <source>Cohort written: %1</source>
        <translation>Zapisano grupę: %1</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>numer %1</translation>
    </message>
    <message>
        <source>And %1 more: choose &quot;Only people who need help&quot; to see them in the table.</source>
        <translation>I jeszcze %1: wybierz „Tylko potrzebujący pomocy”, aby zobaczyć ich w tabeli.</translation>
    </message>
    <message>
        <source>Last score, verdict and number of attempts, or the last score alone where there are many tasks. Enter or double click opens them.</source>
        <translation>Ostatni wynik, ocena i liczba prób, a przy wielu zadaniach sam ostatni wynik. Enter lub dwukrotne kliknięcie je otwiera.</translation>
    </message>
    <message>
        <source>attempts: %1</source>
        <translation>prób: %1</translation>
    </message>
    <message numerus="yes">
        <source>First, last and best score of %n person(s).</source>
        <translation>
            <numerusform>Pierwszy, ostatni i najlepszy wynik %n osoby.</numerusform>
            <numerusform>Pierwszy, ostatni i najlepszy wynik %n osób.</numerusform>
            <numerusform>Pierwszy, ostatni i najlepszy wynik %n osób.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>CommentsCard</name>
    <message>
        <source>Remarks</source>
        <translation>Uwagi</translation>
    </message>
    <message>
        <source>Put the remark back</source>
        <translation>Przywróć uwagę</translation>
    </message>
    <message>
        <source>New remark</source>
        <translation>Nowa uwaga</translation>
    </message>
    <message>
        <source>A remark on what is shown now</source>
        <translation>Uwaga do tego, co teraz widać</translation>
    </message>
    <message>
        <source>A remark on the whole attempt</source>
        <translation>Uwaga do całej próby</translation>
    </message>
    <message>
        <source>Remark here</source>
        <translation>Uwaga w tym miejscu</translation>
    </message>
    <message>
        <source>Add a remark</source>
        <translation>Dodaj uwagę</translation>
    </message>
    <message>
        <source>Saving the remark</source>
        <translation>Zapisywanie uwagi</translation>
    </message>
    <message>
        <source>Removing the remark</source>
        <translation>Usuwanie uwagi</translation>
    </message>
    <message>
        <source>Putting the remark back</source>
        <translation>Przywracanie uwagi</translation>
    </message>
    <message>
        <source>No remarks yet.</source>
        <translation>Nie ma jeszcze uwag.</translation>
    </message>
    <message>
        <source>No remarks. Educators can write them here.</source>
        <translation>Brak uwag. Mogą je tu wpisać instruktorzy.</translation>
    </message>
    <message>
        <source>Look here.</source>
        <translation>Zwróć uwagę na ten moment.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Pokaż</translation>
    </message>
    <message>
        <source>Show the moment %1</source>
        <translation>Pokaż chwilę %1</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Remove remark %1</source>
        <translation>Usuń uwagę %1</translation>
    </message>
</context>
<context>
    <name>Controls</name>
    <message>
        <source>Start for the menu, or hold Enter</source>
        <translation>Start: menu, albo przytrzymaj Enter</translation>
    </message>
    <message>
        <source>hold Enter</source>
        <translation>przytrzymaj Enter</translation>
    </message>
    <message>
        <source>Move the tip in the picture</source>
        <translation>Ruch końcówki w obrazie</translation>
    </message>
    <message>
        <source>move the mouse</source>
        <translation>poruszaj myszą</translation>
    </message>
    <message>
        <source>Go deeper / come back</source>
        <translation>Głębiej / z powrotem</translation>
    </message>
    <message>
        <source>Cut (yellow pedal)</source>
        <translation>Cięcie (żółty pedał)</translation>
    </message>
    <message>
        <source>hold the left button, or X</source>
        <translation>przytrzymaj lewy przycisk lub X</translation>
    </message>
    <message>
        <source>Coagulate (blue pedal)</source>
        <translation>Koagulacja (niebieski pedał)</translation>
    </message>
    <message>
        <source>hold the right button, or C</source>
        <translation>przytrzymaj prawy przycisk lub C</translation>
    </message>
    <message>
        <source>Precision (a fifth of the motion)</source>
        <translation>Precyzja (jedna piąta ruchu)</translation>
    </message>
    <message>
        <source>hold Ctrl</source>
        <translation>przytrzymaj Ctrl</translation>
    </message>
    <message>
        <source>Clutch: move the mouse, not the tip</source>
        <translation>Sprzęgło: ruch myszy bez ruchu końcówki</translation>
    </message>
    <message>
        <source>hold Space</source>
        <translation>przytrzymaj spację</translation>
    </message>
    <message>
        <source>Turn the instrument</source>
        <translation>Obrót narzędzia</translation>
    </message>
    <message>
        <source>hold Shift and move sideways</source>
        <translation>przytrzymaj Shift i przesuń w bok</translation>
    </message>
    <message>
        <source>Steer the scope</source>
        <translation>Prowadzenie fetoskopu</translation>
    </message>
    <message>
        <source>hold the middle button and move; wheel for distance</source>
        <translation>przytrzymaj środkowy przycisk i przesuń; kółko zmienia odległość</translation>
    </message>
    <message>
        <source>Other hand, when there are two</source>
        <translation>Druga ręka, jeśli są dwie</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Finish the task</source>
        <translation>Zakończenie zadania</translation>
    </message>
    <message>
        <source>Move the tip left, right, up, down in the picture</source>
        <translation>Ruch końcówki w lewo, prawo, górę, dół obrazu</translation>
    </message>
    <message>
        <source>A, D, W, S</source>
        <translation>A, D, W, S</translation>
    </message>
    <message>
        <source>F / R</source>
        <translation>F / R</translation>
    </message>
    <message>
        <source>Cut (yellow pedal); slows the tip</source>
        <translation>Cięcie (żółty pedał); spowalnia końcówkę</translation>
    </message>
    <message>
        <source>hold X</source>
        <translation>przytrzymaj X</translation>
    </message>
    <message>
        <source>Coagulate (blue pedal); slows the tip</source>
        <translation>Koagulacja (niebieski pedał); spowalnia końcówkę</translation>
    </message>
    <message>
        <source>hold C</source>
        <translation>przytrzymaj C</translation>
    </message>
    <message>
        <source>Precision (a tenth of the speed)</source>
        <translation>Precyzja (jedna dziesiąta prędkości)</translation>
    </message>
    <message>
        <source>Stop the hand</source>
        <translation>Zatrzymanie ręki</translation>
    </message>
    <message>
        <source>Q / E</source>
        <translation>Q / E</translation>
    </message>
    <message>
        <source>arrow keys</source>
        <translation>klawisze strzałek</translation>
    </message>
    <message>
        <source>left stick</source>
        <translation>lewa gałka</translation>
    </message>
    <message>
        <source>right trigger / left trigger</source>
        <translation>prawy spust / lewy spust</translation>
    </message>
    <message>
        <source>hold the lower button (A or cross)</source>
        <translation>przytrzymaj dolny przycisk (A lub krzyżyk)</translation>
    </message>
    <message>
        <source>hold the right button (B or circle)</source>
        <translation>przytrzymaj prawy przycisk (B lub kółko)</translation>
    </message>
    <message>
        <source>hold the left bumper</source>
        <translation>przytrzymaj lewy bumper</translation>
    </message>
    <message>
        <source>right stick sideways</source>
        <translation>prawa gałka w bok</translation>
    </message>
    <message>
        <source>hold Space on the keyboard</source>
        <translation>przytrzymaj spację na klawiaturze</translation>
    </message>
    <message>
        <source>wheel away from you / towards you (half a millimetre; with Shift 2 mm)</source>
        <translation>kółko od siebie / do siebie (pół milimetra; z Shift 2 mm)</translation>
    </message>
    <message>
        <source>push the cap sideways and up or down</source>
        <translation>przesuwaj gałkę na boki i w górę lub w dół</translation>
    </message>
    <message>
        <source>push the cap away from you / pull it</source>
        <translation>pchnij gałkę od siebie / pociągnij do siebie</translation>
    </message>
    <message>
        <source>hold the left button, or the yellow pedal</source>
        <translation>przytrzymaj lewy przycisk lub żółty pedał</translation>
    </message>
    <message>
        <source>hold the right button, or the blue pedal</source>
        <translation>przytrzymaj prawy przycisk lub niebieski pedał</translation>
    </message>
    <message>
        <source>twist the cap</source>
        <translation>obracaj gałkę</translation>
    </message>
    <message>
        <source>Move the handle outside the body</source>
        <translation>Ruch uchwytu na zewnątrz ciała</translation>
    </message>
    <message>
        <source>move the arm; the port inverts</source>
        <translation>poruszaj ramieniem; port odwraca ruch</translation>
    </message>
    <message>
        <source>yellow pedal, or the first button</source>
        <translation>żółty pedał lub pierwszy przycisk</translation>
    </message>
    <message>
        <source>blue pedal, or the third button</source>
        <translation>niebieski pedał lub trzeci przycisk</translation>
    </message>
    <message>
        <source>Close the jaws</source>
        <translation>Zamykanie szczęk</translation>
    </message>
    <message>
        <source>turn the stylus</source>
        <translation>obracaj rysik</translation>
    </message>
    <message>
        <source>Clutch: move the arm, not the handle</source>
        <translation>Sprzęgło: ruch ramienia bez ruchu uchwytu</translation>
    </message>
    <message>
        <source>hold the second button</source>
        <translation>przytrzymaj drugi przycisk</translation>
    </message>
    <message>
        <source>Other instrument</source>
        <translation>Inne narzędzie</translation>
    </message>
    <message>
        <source>tap the second button, or Tab</source>
        <translation>naciśnij krótko drugi przycisk lub Tab</translation>
    </message>
    <message>
        <source>Move the instrument in its port</source>
        <translation>Ruch narzędzia w porcie</translation>
    </message>
    <message>
        <source>move the handle; the port inverts</source>
        <translation>poruszaj uchwytem; port odwraca ruch</translation>
    </message>
    <message>
        <source>yellow pedal</source>
        <translation>żółty pedał</translation>
    </message>
    <message>
        <source>blue pedal</source>
        <translation>niebieski pedał</translation>
    </message>
    <message>
        <source>close the handle</source>
        <translation>zamknij uchwyt</translation>
    </message>
    <message>
        <source>turn the handle</source>
        <translation>obracaj uchwyt</translation>
    </message>
    <message>
        <source>hold the first button, or the arm's gripper</source>
        <translation>przytrzymaj pierwszy przycisk lub chwytak ramienia</translation>
    </message>
</context>
<context>
    <name>CoursePage</name>
    <message>
        <source>Course</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Otwarte</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Powtórz</translation>
    </message>
    <message>
        <source>Open task %1</source>
        <translation>Otwórz zadanie %1</translation>
    </message>
    <message>
        <source>Cannot be used</source>
        <translation>Nie działa</translation>
    </message>
    <message>
        <source>Mastered</source>
        <translation>Zaliczone</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Zamknięte</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Następne</translation>
    </message>
    <message>
        <source> · not tried yet</source>
        <translation> · jeszcze bez prób</translation>
    </message>
    <message>
        <source> · streak %1 · best %2 · attempts %3</source>
        <translation> · seria %1 · najlepszy wynik %2 · próby %3</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Rozpocznij</translation>
    </message>
    <message>
        <source>The course is mastered</source>
        <translation>Kurs jest zaliczony</translation>
    </message>
    <message>
        <source>The course is mastered in version %1</source>
        <translation>Kurs jest zaliczony w wersji %1</translation>
    </message>
    <message>
        <source>Certificate %1, mastered on %2</source>
        <translation>Certyfikat %1, zaliczono %2</translation>
    </message>
    <message>
        <source>Your certificate is ready to be issued.</source>
        <translation>Certyfikat jest gotowy do wydania.</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certyfikat</translation>
    </message>
    <message>
        <source>Write the certificate</source>
        <translation>Zapisz certyfikat</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Writing the certificate</source>
        <translation>Zapisywanie certyfikatu</translation>
    </message>
    <message>
        <source>Certificate written: %1</source>
        <translation>Zapisano certyfikat: %1</translation>
    </message>
    <message>
        <source>To the exam</source>
        <translation>Do egzaminu</translation>
    </message>
    <message>
        <source>All attempts used</source>
        <translation>Wykorzystano wszystkie próby</translation>
    </message>
    <message>
        <source> · left: %1</source>
        <translation> · pozostało: %1</translation>
    </message>
    <message>
        <source>Locked. Opens when mastered: %1</source>
        <translation>Zamknięte. Otwiera się po zaliczeniu: %1</translation>
    </message>
    <message>
        <source> · open to everybody: needs no stage before it</source>
        <translation> · otwarte dla wszystkich: nie wymaga wcześniejszego etapu</translation>
    </message>
    <message>
        <source> · tried, does not count: %1</source>
        <translation> · próbowano, nie liczy się: %1</translation>
    </message>
    <message>
        <source> · begun, not finished: %1</source>
        <translation> · rozpoczęte, nieukończone: %1</translation>
    </message>
</context>
<context>
    <name>Device</name>
    <message>
        <source>tip in the picture's plane, wheel for depth; no force</source>
        <translation>końcówka w płaszczyźnie obrazu, kółko to głębokość; bez siły</translation>
    </message>
    <message>
        <source>fixed speeds; no force</source>
        <translation>stałe prędkości; bez siły</translation>
    </message>
    <message>
        <source>sticks and triggers; no force; needs a pad with a standard mapping</source>
        <translation>gałki i spusty; bez siły; potrzebny pad o standardowym układzie</translation>
    </message>
    <message>
        <source>3Dconnexion SpaceMouse over spacenavd</source>
        <translation>3Dconnexion SpaceMouse przez spacenavd</translation>
    </message>
    <message>
        <source>Touch, Touch X, Omni over OpenHaptics</source>
        <translation>Touch, Touch X, Omni przez OpenHaptics</translation>
    </message>
    <message>
        <source>Haply Inverse3</source>
        <translation>Haply Inverse3</translation>
    </message>
    <message>
        <source>Follou Haptic Avatar</source>
        <translation>Follou Haptic Avatar</translation>
    </message>
    <message>
        <source>Force Dimension omega, delta, sigma, lambda</source>
        <translation>Force Dimension omega, delta, sigma, lambda</translation>
    </message>
</context>
<context>
    <name>Figure</name>
    <message>
        <source>placode</source>
        <translation>płytka nerwowa</translation>
    </message>
    <message>
        <source>junctional zone</source>
        <translation>strefa łącząca</translation>
    </message>
    <message>
        <source>skin</source>
        <translation>skóra</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>Oględziny</translation>
    </message>
    <message>
        <source>Incise</source>
        <translation>Nacięcie</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Uwolnienie</translation>
    </message>
    <message>
        <source>Resect</source>
        <translation>Wycięcie</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Kontrola</translation>
    </message>
    <message>
        <source>Placode</source>
        <translation>Płytka</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Siła</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Tkanka</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energia</translation>
    </message>
    <message>
        <source>needle</source>
        <translation>igła</translation>
    </message>
    <message>
        <source>scissors</source>
        <translation>nożyczki</translation>
    </message>
    <message>
        <source>grasper</source>
        <translation>chwytak</translation>
    </message>
    <message>
        <source>scope</source>
        <translation>fetoskop</translation>
    </message>
    <message>
        <source>irrigator</source>
        <translation>irygator</translation>
    </message>
    <message>
        <source>needle driver</source>
        <translation>imadło</translation>
    </message>
    <message>
        <source>instrument</source>
        <translation>narzędzie</translation>
    </message>
    <message>
        <source>min:s</source>
        <translation>min:s</translation>
    </message>
    <message>
        <source>No damage was recorded.</source>
        <translation>Nie zapisano żadnego uszkodzenia.</translation>
    </message>
    <message>
        <source>12 = cranial</source>
        <translation>12 = strona głowowa</translation>
    </message>
    <message>
        <source>energy into tissue</source>
        <translation>energia w tkance</translation>
    </message>
    <message>
        <source>critical</source>
        <translation>krytyczne</translation>
    </message>
    <message>
        <source>other harm</source>
        <translation>inne uszkodzenie</translation>
    </message>
    <message>
        <source>number of entries</source>
        <translation>liczba wpisów</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Z góry</translation>
    </message>
    <message>
        <source>From the left side</source>
        <translation>Z lewej strony</translation>
    </message>
    <message>
        <source>From the feet</source>
        <translation>Od strony stóp</translation>
    </message>
    <message>
        <source>left</source>
        <translation>lewa</translation>
    </message>
    <message>
        <source>right</source>
        <translation>prawa</translation>
    </message>
    <message>
        <source>cranial</source>
        <translation>głowowo</translation>
    </message>
    <message>
        <source>caudal</source>
        <translation>ogonowo</translation>
    </message>
    <message>
        <source>outward</source>
        <translation>na zewnątrz</translation>
    </message>
    <message>
        <source>inward</source>
        <translation>w głąb</translation>
    </message>
    <message>
        <source>Damage over time</source>
        <translation>Uszkodzenia w czasie</translation>
    </message>
    <message>
        <source>Damage and energy on the anatomy</source>
        <translation>Uszkodzenia i energia na anatomii</translation>
    </message>
    <message>
        <source>Damage on the anatomy</source>
        <translation>Uszkodzenia na anatomii</translation>
    </message>
    <message>
        <source>Paths of the instruments</source>
        <translation>Drogi narzędzi</translation>
    </message>
    <message>
        <source>cranial (12 o'clock)</source>
        <translation>głowowo (godzina 12)</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>plan</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>nacięte</translation>
    </message>
    <message>
        <source>harm</source>
        <translation>uszkodzenie</translation>
    </message>
    <message>
        <source>followed</source>
        <translation>obwiedziona</translation>
    </message>
    <message>
        <source>done</source>
        <translation>wykonane</translation>
    </message>
    <message>
        <source>not done</source>
        <translation>niewykonane</translation>
    </message>
    <message>
        <source>beside it</source>
        <translation>obok</translation>
    </message>
    <message>
        <source>attempt</source>
        <translation>próba</translation>
    </message>
    <message>
        <source>score [points of 100]</source>
        <translation>wynik [punkty na 100]</translation>
    </message>
    <message>
        <source>No energy reached tissue.</source>
        <translation>Do tkanki nie dotarła energia.</translation>
    </message>
    <message>
        <source>pass mark of the task: %1</source>
        <translation>próg zaliczenia zadania: %1</translation>
    </message>
    <message>
        <source>novices</source>
        <translation>początkujący</translation>
    </message>
    <message>
        <source>experts</source>
        <translation>eksperci</translation>
    </message>
    <message>
        <source>cut at %1</source>
        <translation>próg %1</translation>
    </message>
    <message>
        <source>thick: mean of all</source>
        <translation>gruba: średnia wszystkich</translation>
    </message>
    <message>
        <source>thin: each person</source>
        <translation>cienka: każda osoba</translation>
    </message>
    <message>
        <source>CUSUM of attempts not passed</source>
        <translation>CUSUM niezaliczonych prób</translation>
    </message>
    <message>
        <source>h1 %1 unacceptable</source>
        <translation>h1 %1 nie do przyjęcia</translation>
    </message>
    <message>
        <source>h0 %1 acceptable</source>
        <translation>h0 %1 do przyjęcia</translation>
    </message>
    <message>
        <source>Where it leaks</source>
        <translation>Gdzie przecieka</translation>
    </message>
    <message>
        <source>leak at 12.5 cmH2O [ml/min]</source>
        <translation>przeciek przy 12,5 cmH2O [ml/min]</translation>
    </message>
    <message>
        <source>nothing leaks</source>
        <translation>nic nie przecieka</translation>
    </message>
    <message>
        <source>bites: filled = in, open = out, dashed = not finished</source>
        <translation>ściegi: pełne = wkłucie, puste = wykłucie, kreski = nieukończony</translation>
    </message>
    <message>
        <source>no bite</source>
        <translation>brak ściegu</translation>
    </message>
    <message>
        <source>gap [mm]: grey without pressure, line at 12.5 cmH2O</source>
        <translation>szczelina [mm]: szara bez ciśnienia, linia przy 12,5 cmH2O</translation>
    </message>
    <message>
        <source>gap [mm] without pressure</source>
        <translation>szczelina [mm] bez ciśnienia</translation>
    </message>
    <message>
        <source>upper end</source>
        <translation>górny koniec</translation>
    </message>
    <message>
        <source>lower end</source>
        <translation>dolny koniec</translation>
    </message>
    <message>
        <source>left end</source>
        <translation>lewy koniec</translation>
    </message>
    <message>
        <source>right end</source>
        <translation>prawy koniec</translation>
    </message>
    <message>
        <source>burst at %1 cmH2O</source>
        <translation>puścił przy %1 cmH2O</translation>
    </message>
</context>
<context>
    <name>DailyBackupCard</name>
    <message>
        <source>Every day by itself</source>
        <translation>Codziennie sama</translation>
    </message>
    <message>
        <source>A copy of this user's store every day, opened and checked; the last 30 stay. Copy their folder to another disk yourself.</source>
        <translation>Codziennie kopia bazy tego użytkownika, otwarta i sprawdzona; zostaje 30 ostatnich. Na inny dysk skopiuj ich folder samodzielnie.</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>Włącz</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>Wyłącz</translation>
    </message>
    <message>
        <source>✓ It is on.</source>
        <translation>✓ Włączona.</translation>
    </message>
    <message>
        <source>It copies another store of this user, not this one. Switch it on here to copy this one instead.</source>
        <translation>Kopiowana jest inna baza tego użytkownika, a nie ta. Włącz kopię tutaj, aby zamiast tamtej kopiować tę.</translation>
    </message>
    <message>
        <source>It is off.</source>
        <translation>Wyłączona.</translation>
    </message>
    <message>
        <source>It cannot be switched here: Placode was not installed as a package, or this computer runs no systemd for users.</source>
        <translation>Nie można jej tu włączyć: Placode nie zainstalowano z pakietu albo na tym komputerze nie działa systemd użytkownika.</translation>
    </message>
    <message>
        <source>The daily backup could not be switched.</source>
        <translation>Nie udało się przełączyć codziennej kopii.</translation>
    </message>
    <message>
        <source>Ask whoever looks after this computer.</source>
        <translation>Poproś osobę, która opiekuje się tym komputerem.</translation>
    </message>
    <message>
        <source>Writing the audit</source>
        <translation>Zapis w dzienniku</translation>
    </message>
    <message>
        <source>No daily copy was made yet.</source>
        <translation>Nie ma jeszcze codziennej kopii.</translation>
    </message>
    <message>
        <source>The newest daily copy did not pass its check: %1</source>
        <translation>Najnowsza codzienna kopia nie przeszła sprawdzenia: %1</translation>
    </message>
    <message>
        <source>Newest daily copy: %1</source>
        <translation>Najnowsza codzienna kopia: %1</translation>
    </message>
</context>
<context>
    <name>DiagnosticsDialog</name>
    <message>
        <source>Log and crash reports</source>
        <translation>Dziennik programów i raporty awarii</translation>
    </message>
    <message>
        <source>They lie on this computer only, and nobody gets them unless you send them. They hold no names, log-ins or results: which program started, ended or failed, and where in the program.</source>
        <translation>Leżą tylko na tym komputerze i nikt ich nie dostanie, jeśli ich nie wyślesz. Nie zawierają nazwisk, loginów ani wyników: tylko to, który program się uruchomił, zakończył lub zawiódł i w którym swoim miejscu.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Pokaż</translation>
    </message>
    <message>
        <source>What was written</source>
        <translation>Co zapisano</translation>
    </message>
    <message>
        <source>Delete this report</source>
        <translation>Usuń ten raport</translation>
    </message>
    <message>
        <source>Save a copy</source>
        <translation>Zapisz kopię</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>Crash of %1, %2</source>
        <translation>Awaria programu %1, %2</translation>
    </message>
    <message>
        <source>Log of the programs</source>
        <translation>Dziennik programów</translation>
    </message>
    <message>
        <source>Nothing was written yet.</source>
        <translation>Nic jeszcze nie zapisano.</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Tekst (*.txt)</translation>
    </message>
    <message>
        <source>The copy could not be written.</source>
        <translation>Nie udało się zapisać kopii.</translation>
    </message>
    <message>
        <source>Choose another folder, or make room on the disk.</source>
        <translation>Wybierz inny folder albo zwolnij miejsce na dysku.</translation>
    </message>
    <message>
        <source>%1 crashed on %2. What it wrote about that is on this computer.</source>
        <translation>Program %1 uległ awarii: %2. Jego raport jest na tym komputerze.</translation>
    </message>
    <message>
        <source>Read the report</source>
        <translation>Przeczytaj raport</translation>
    </message>
    <message>
        <source>Delete this report?</source>
        <translation>Usunąć ten raport?</translation>
    </message>
    <message>
        <source>It is the only copy. Save one before, if somebody is to look into it.</source>
        <translation>To jedyny egzemplarz. Jeśli ktoś ma się nim zająć, najpierw zapisz kopię.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Usuń</translation>
    </message>
</context>
<context>
    <name>HealthPage</name>
    <message>
        <source>The programs on this computer</source>
        <translation>Programy na tym komputerze</translation>
    </message>
    <message>
        <source>What started, ended and failed here, without names or results. Read it before you send it to whoever looks for a fault.</source>
        <translation>Co się tu uruchomiło, zakończyło i zawiodło, bez nazwisk i wyników. Przeczytaj, zanim wyślesz to komuś, kto szuka błędu.</translation>
    </message>
    <message>
        <source>Log and crash reports</source>
        <translation>Dziennik programów i raporty awarii</translation>
    </message>
    <message>
        <source>Placode&apos;s log-in to the server can change scores and the audit list. Give each station a log-in of its own: see the chapter &quot;A store for several stations&quot;.</source>
        <translation>Login Placode do serwera może zmieniać wyniki i dziennik. Daj każdemu stanowisku własny login: zobacz rozdział „Jedna baza dla kilku stanowisk”.</translation>
    </message>
    <message>
        <source>Backup and health</source>
        <translation>Kopie i stan</translation>
    </message>
    <message>
        <source>The store</source>
        <translation>Baza danych</translation>
    </message>
    <message>
        <source>Size: %1</source>
        <translation>Rozmiar: %1</translation>
    </message>
    <message>
        <source>Not checked since this page was opened.</source>
        <translation>Nie sprawdzono od otwarcia tej strony.</translation>
    </message>
    <message>
        <source>Check the store</source>
        <translation>Sprawdź bazę</translation>
    </message>
    <message>
        <source>Checking the store</source>
        <translation>Sprawdzanie bazy</translation>
    </message>
    <message>
        <source>Cancel the check</source>
        <translation>Przerwij sprawdzanie</translation>
    </message>
    <message>
        <source>The check was cancelled. It has not said whether the store is sound.</source>
        <translation>Sprawdzanie przerwano. Nie wiadomo, czy baza jest w porządku.</translation>
    </message>
    <message>
        <source>The check could not be finished.</source>
        <translation>Nie udało się dokończyć sprawdzenia.</translation>
    </message>
    <message>
        <source>✓ Sound: no problem found.</source>
        <translation>✓ W porządku: nie znaleziono problemów.</translation>
    </message>
    <message>
        <source>Problems found:</source>
        <translation>Znalezione problemy:</translation>
    </message>
    <message>
        <source>Backup</source>
        <translation>Kopia zapasowa</translation>
    </message>
    <message>
        <source>A consistent copy, also while people work: accounts, attempts with their recordings, answers, audit. It holds personal data; keep it as safe as the store.</source>
        <translation>Spójna kopia, także podczas pracy: konta, próby z nagraniami, odpowiedzi, dziennik. Zawiera dane osobowe; chroń ją tak samo jak bazę.</translation>
    </message>
    <message>
        <source>No backup was made from this machine yet.</source>
        <translation>Z tego komputera nie wykonano jeszcze kopii.</translation>
    </message>
    <message>
        <source>Last backup: %1</source>
        <translation>Ostatnia kopia: %1</translation>
    </message>
    <message>
        <source>Back up now</source>
        <translation>Wykonaj kopię</translation>
    </message>
    <message>
        <source>Back up the store</source>
        <translation>Kopia bazy</translation>
    </message>
    <message>
        <source>Placode store (*.db)</source>
        <translation>Baza Placode (*.db)</translation>
    </message>
    <message>
        <source>Backing up the store</source>
        <translation>Tworzenie kopii bazy</translation>
    </message>
    <message>
        <source>Noting the backup</source>
        <translation>Zapis informacji o kopii</translation>
    </message>
    <message>
        <source>Backup written: %1</source>
        <translation>Kopia zapisana: %1</translation>
    </message>
    <message>
        <source>A file on this computer: %1</source>
        <translation>Plik na tym komputerze: %1</translation>
    </message>
    <message>
        <source>A server of the centre (PostgreSQL)</source>
        <translation>Serwer ośrodka (PostgreSQL)</translation>
    </message>
    <message>
        <source>The centre&apos;s signing key lies in clear in this store and in its backups: whoever reads them can sign norm packs in the centre&apos;s name. Put it under a passphrase here, or with `placodectl norms key seal`.</source>
        <translation>Klucz podpisu ośrodka leży jawnie w tej bazie i w jej kopiach: kto je odczyta, może podpisywać pakiety norm w imieniu ośrodka. Zabezpiecz go hasłem tutaj albo poleceniem `placodectl norms key seal`.</translation>
    </message>
    <message>
        <source>Choose a passphrase</source>
        <translation>Wybierz hasło klucza</translation>
    </message>
    <message>
        <source>Whoever signs norm packs of this centre needs it from now on. Keep it in another place; without it only a new key helps.</source>
        <translation>Od tej chwili potrzebuje go każdy, kto podpisuje pakiety norm tego ośrodka. Przechowuj je w innym miejscu; bez niego pomoże tylko nowy klucz.</translation>
    </message>
    <message>
        <source>Seal the key</source>
        <translation>Zabezpiecz klucz</translation>
    </message>
    <message>
        <source>The key is sealed. Earlier backups hold it in clear: make a new one, and remove them.</source>
        <translation>Klucz jest zabezpieczony. Wcześniejsze kopie zawierają go jawnie: utwórz nową i usuń je.</translation>
    </message>
</context>
<context>
    <name>HistoryPage</name>
    <message>
        <source>Report</source>
        <translation>Raport</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historia</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Zadanie</translation>
    </message>
    <message>
        <source>No attempts yet</source>
        <translation>Nie ma jeszcze prób</translation>
    </message>
    <message>
        <source>After your first attempt this page shows how your score develops.</source>
        <translation>Po pierwszej próbie ta strona pokaże, jak zmienia się wynik.</translation>
    </message>
    <message>
        <source>Open the course</source>
        <translation>Otwórz kurs</translation>
    </message>
    <message>
        <source>Score over attempts</source>
        <translation>Wynik w kolejnych próbach</translation>
    </message>
    <message>
        <source>The same numbers stand in the table below.</source>
        <translation>Te same liczby są w tabeli poniżej.</translation>
    </message>
    <message>
        <source>Enter or double click opens the result.</source>
        <translation>Enter lub dwukrotne kliknięcie otwiera wynik.</translation>
    </message>
    <message>
        <source>Learning curve</source>
        <translation>Krzywa uczenia</translation>
    </message>
    <message>
        <source>The curve approaches %1 points; 95 % of the gain is reached after about %2 attempts. %3</source>
        <translation>Krzywa zbliża się do %1 pkt; 95 % postępu zostaje osiągnięte po około %2 próbach. %3</translation>
    </message>
    <message>
        <source>You are on the plateau.</source>
        <translation>Osiągnięto plateau.</translation>
    </message>
    <message>
        <source>There is still gain to come.</source>
        <translation>Możliwy jest dalszy postęp.</translation>
    </message>
    <message>
        <source>No learning curve: what fits the scores does not rise.</source>
        <translation>Nie ma krzywej uczenia: krzywa dopasowana do wyników nie rośnie.</translation>
    </message>
    <message>
        <source>No curve fits yet: the scores go up and down without a trend.</source>
        <translation>Żadna krzywa jeszcze nie pasuje: wyniki rosną i spadają bez trendu.</translation>
    </message>
    <message>
        <source>All scores are equal: there is no curve to fit.</source>
        <translation>Wszystkie wyniki są równe: nie ma krzywej do dopasowania.</translation>
    </message>
    <message>
        <source>Learning curve and CUSUM</source>
        <translation>Krzywa uczenia i CUSUM</translation>
    </message>
    <message>
        <source>Below: CUSUM of attempts that were not passed. Above the upper limit performance is not acceptable, below the lower one it is (Bolsin and Colson 2000).</source>
        <translation>Poniżej: CUSUM niezaliczonych prób. Powyżej górnej granicy poziom jest nieakceptowalny, poniżej dolnej akceptowalny (Bolsin i Colson 2000).</translation>
    </message>
    <message>
        <source>CUSUM: since attempt %1 too many attempts are not passed. Practise the stage before with your educator.</source>
        <translation>CUSUM: od próby %1 zbyt wiele prób jest niezaliczonych. Poćwicz poprzedni etap z instruktorem.</translation>
    </message>
    <message>
        <source>CUSUM: since attempt %1 the share of attempts that are not passed is acceptable.</source>
        <translation>CUSUM: od próby %1 odsetek niezaliczonych prób jest do przyjęcia.</translation>
    </message>
    <message>
        <source>CUSUM: between the limits, more attempts will decide.</source>
        <translation>CUSUM: między granicami, rozstrzygną kolejne próby.</translation>
    </message>
    <message>
        <source>Open the task</source>
        <translation>Otwórz zadanie</translation>
    </message>
</context>
<context>
    <name>Leak</name>
    <message>
        <source>%1 mm from the upper end</source>
        <translation>%1 mm od górnego końca</translation>
    </message>
    <message>
        <source>%1 mm from the left end</source>
        <translation>%1 mm od lewego końca</translation>
    </message>
    <message>
        <source>It is tight at 12.5 cmH2O.</source>
        <translation>Przy 12,5 cmH2O jest szczelne.</translation>
    </message>
    <message>
        <source>the rest lets %1 ml/min through</source>
        <translation>reszta przepuszcza %1 ml/min</translation>
    </message>
    <message>
        <source>the rest is tight</source>
        <translation>reszta jest szczelna</translation>
    </message>
    <message>
        <source>there is no finished bite</source>
        <translation>nie ma ukończonego ściegu</translation>
    </message>
    <message>
        <source>It leaks most%1: %2 ml/min at 12.5 cmH2O; %3.</source>
        <translation>Najbardziej przecieka%1: %2 ml/min przy 12,5 cmH2O; %3.</translation>
    </message>
    <message>
        <source>It held up to %1 cmH2O; where it burst then was not recorded.</source>
        <translation>Utrzymało do %1 cmH2O; nie zapisano, gdzie potem puściło.</translation>
    </message>
    <message>
        <source>It held %1 cmH2O, the end of the test.</source>
        <translation>Utrzymało %1 cmH2O, do końca próby.</translation>
    </message>
    <message>
        <source>It burst at %1 cmH2O%2.</source>
        <translation>Puściło przy %1 cmH2O%2.</translation>
    </message>
    <message>
        <source>No map: this recording does not say what leaks where.</source>
        <translation>Brak mapy: to nagranie nie mówi, gdzie ile przecieka.</translation>
    </message>
</context>
<context>
    <name>Ledger</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>at most %1 mN</source>
        <translation>najwyżej %1 mN</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>%1 o'clock</source>
        <translation>godzina %1</translation>
    </message>
    <message>
        <source>Placode touched</source>
        <translation>Dotknięcie płytki</translation>
    </message>
    <message>
        <source>Placode touched with energy on</source>
        <translation>Dotknięcie płytki z włączoną energią</translation>
    </message>
    <message>
        <source>Placode overheated</source>
        <translation>Przegrzanie płytki</translation>
    </message>
    <message>
        <source>Placode burned</source>
        <translation>Oparzenie płytki</translation>
    </message>
    <message>
        <source>Placode cut by scissors</source>
        <translation>Nacięcie płytki nożyczkami</translation>
    </message>
    <message>
        <source>Force above the scene's limit</source>
        <translation>Siła powyżej granicy sceny</translation>
    </message>
    <message>
        <source>Pulled too hard</source>
        <translation>Zbyt mocne pociągnięcie</translation>
    </message>
    <message>
        <source>Crushed between the jaws</source>
        <translation>Zmiażdżenie w szczękach</translation>
    </message>
    <message>
        <source>Slid out of the jaws</source>
        <translation>Wysunięcie ze szczęk</translation>
    </message>
    <message>
        <source>Needle slid in the jaws</source>
        <translation>Igła przesunęła się w szczękach</translation>
    </message>
    <message>
        <source>Needle turned in the jaws</source>
        <translation>Igła obróciła się w szczękach</translation>
    </message>
    <message>
        <source>Needle dropped</source>
        <translation>Igła upuszczona</translation>
    </message>
    <message>
        <source>Thread cut through tissue</source>
        <translation>Nić przecięła tkankę</translation>
    </message>
    <message>
        <source>Thread tore out of tissue</source>
        <translation>Nić wyrwała się z tkanki</translation>
    </message>
    <message>
        <source>Placode torn</source>
        <translation>Rozdarcie płytki</translation>
    </message>
    <message>
        <source>Placode cut by heat</source>
        <translation>Nacięcie płytki ciepłem</translation>
    </message>
    <message>
        <source>Cut into healthy skin</source>
        <translation>Cięcie w zdrowej skórze</translation>
    </message>
    <message>
        <source>Skin cut by scissors</source>
        <translation>Nacięcie skóry nożyczkami</translation>
    </message>
    <message>
        <source>Energy in the air</source>
        <translation>Energia poza tkanką</translation>
    </message>
    <message>
        <source>Resting on one spot with energy on</source>
        <translation>Postój w miejscu z włączoną energią</translation>
    </message>
    <message>
        <source>Tip stuck in tissue</source>
        <translation>Końcówka utkwiła w tkance</translation>
    </message>
    <message>
        <source>Tissue torn</source>
        <translation>Rozerwana tkanka</translation>
    </message>
</context>
<context>
    <name>LedgerView</name>
    <message>
        <source>Damage over time</source>
        <translation>Uszkodzenia w czasie</translation>
    </message>
    <message>
        <source>Click an entry, or use the arrow keys</source>
        <translation>Kliknij wpis albo użyj strzałek</translation>
    </message>
    <message>
        <source>critical</source>
        <translation>krytyczne</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s). Arrow keys go from one to the next.</source>
        <translation>
            <numerusform>%n wpis. Strzałki przechodzą od jednego do następnego.</numerusform>
            <numerusform>%n wpisy. Strzałki przechodzą od jednego do następnego.</numerusform>
            <numerusform>%n wpisów. Strzałki przechodzą od jednego do następnego.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>LoginPage</name>
    <message>
        <source>Go on as %1</source>
        <translation>Kontynuuj jako %1</translation>
    </message>
    <message>
        <source>This profile has no password. Under My account you can make an account of it.</source>
        <translation>Ten profil nie ma hasła. Na stronie „Moje konto” możesz założyć dla niego konto.</translation>
    </message>
    <message>
        <source>Sign in</source>
        <translation>Zaloguj się</translation>
    </message>
    <message>
        <source>Fetoscopic spina bifida repair: practise, see, repeat.</source>
        <translation>Fetoskopowa operacja rozszczepu kręgosłupa: ćwicz, zobacz, powtórz.</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Hasło</translation>
    </message>
    <message>
        <source>Sign in as %1</source>
        <translation>Zaloguj się jako %1</translation>
    </message>
    <message>
        <source>Type your log-in name and your password.</source>
        <translation>Wpisz login i hasło.</translation>
    </message>
    <message>
        <source>Signing in</source>
        <translation>Logowanie</translation>
    </message>
    <message>
        <source>This account is deactivated. An administrator can open it again.</source>
        <translation>To konto jest wyłączone. Administrator może je włączyć.</translation>
    </message>
    <message>
        <source>Log-in name or password is wrong. Try again.</source>
        <translation>Login lub hasło jest błędne. Spróbuj ponownie.</translation>
    </message>
    <message>
        <source>Too many wrong passwords. Try again in %1 s.</source>
        <translation>Zbyt wiele błędnych haseł. Spróbuj ponownie za %1 s.</translation>
    </message>
    <message>
        <source>Your PIN is enough here: you signed in not long ago.</source>
        <translation>Tu wystarczy PIN: logowanie było niedawno.</translation>
    </message>
    <message>
        <source>I have an invitation</source>
        <translation>Mam zaproszenie</translation>
    </message>
    <message>
        <source>The PIN is wrong. Try again, or type your password.</source>
        <translation>PIN jest błędny. Spróbuj ponownie lub wpisz hasło.</translation>
    </message>
    <message>
        <source>Three wrong PINs: type your password.</source>
        <translation>Trzy błędne kody PIN: wpisz hasło.</translation>
    </message>
    <message>
        <source>Log-in name</source>
        <translation>Login</translation>
    </message>
    <message>
        <source>This is a demonstration: choose who you want to be. The password of all is &quot;%1&quot;.</source>
        <translation>To jest demonstracja: wybierz, kim chcesz być. Hasło wszystkich to „%1”.</translation>
    </message>
</context>
<context>
    <name>Metric</name>
    <message>
        <source>Steps done</source>
        <translation>Wykonane kroki</translation>
    </message>
    <message>
        <source>Distance from targets</source>
        <translation>Odległość od celów</translation>
    </message>
    <message>
        <source>Targets missed</source>
        <translation>Chybione cele</translation>
    </message>
    <message>
        <source>Entry beside its mark</source>
        <translation>Wkłucie obok znaku</translation>
    </message>
    <message>
        <source>Exit beside its mark</source>
        <translation>Wykłucie obok znaku</translation>
    </message>
    <message>
        <source>Depth of the bite</source>
        <translation>Głębokość przejścia igły</translation>
    </message>
    <message>
        <source>Angle of the needle</source>
        <translation>Kąt igły</translation>
    </message>
    <message>
        <source>Bites done</source>
        <translation>Ukończone ściegi</translation>
    </message>
    <message>
        <source>Shut part of the slit</source>
        <translation>Zamknięta część rozcięcia</translation>
    </message>
    <message>
        <source>Gap of the slit, mean</source>
        <translation>Szczelina rozcięcia, średnia</translation>
    </message>
    <message>
        <source>Gap of the slit, widest</source>
        <translation>Szczelina rozcięcia, największa</translation>
    </message>
    <message>
        <source>Leak of the slit, calculated</source>
        <translation>Przeciek przez rozcięcie, obliczony</translation>
    </message>
    <message>
        <source>Leak of the slit at 6 cmH2O</source>
        <translation>Przeciek przez rozcięcie przy 6 cmH2O</translation>
    </message>
    <message>
        <source>Leak of the slit at 12.5 cmH2O</source>
        <translation>Przeciek przez rozcięcie przy 12,5 cmH2O</translation>
    </message>
    <message>
        <source>Burst pressure of the slit</source>
        <translation>Ciśnienie, przy którym szew puszcza</translation>
    </message>
    <message>
        <source>Place of the worst leak</source>
        <translation>Miejsce największego przecieku</translation>
    </message>
    <message>
        <source>Bites before the worst leak</source>
        <translation>Ściegi przed największym przeciekiem</translation>
    </message>
    <message>
        <source>Place of the burst</source>
        <translation>Miejsce, w którym szew puścił</translation>
    </message>
    <message>
        <source>Entry beside its mark, worst bite</source>
        <translation>Wkłucie obok znaku, najgorszy ścieg</translation>
    </message>
    <message>
        <source>Exit beside its mark, worst bite</source>
        <translation>Wykłucie obok znaku, najgorszy ścieg</translation>
    </message>
    <message>
        <source>Shallowest bite</source>
        <translation>Najpłytszy ścieg</translation>
    </message>
    <message>
        <source>Deepest bite</source>
        <translation>Najgłębszy ścieg</translation>
    </message>
    <message>
        <source>Spread of the depth</source>
        <translation>Rozrzut głębokości</translation>
    </message>
    <message>
        <source>Pitch of the bites</source>
        <translation>Odstęp ściegów</translation>
    </message>
    <message>
        <source>Spread of the pitch</source>
        <translation>Rozrzut odstępów</translation>
    </message>
    <message>
        <source>Asymmetry, worst bite</source>
        <translation>Asymetria, najgorszy ścieg</translation>
    </message>
    <message>
        <source>Angle of the needle, flattest bite</source>
        <translation>Kąt igły, najbardziej płaski ścieg</translation>
    </message>
    <message>
        <source>Edge overlapped by the patch</source>
        <translation>Brzeg przykryty łatą z zakładem</translation>
    </message>
    <message>
        <source>Overlap of the patch, mean</source>
        <translation>Zakład łaty, średni</translation>
    </message>
    <message>
        <source>Overlap of the patch, least</source>
        <translation>Zakład łaty, najmniejszy</translation>
    </message>
    <message>
        <source>Placode left open</source>
        <translation>Odsłonięta część płytki</translation>
    </message>
    <message>
        <source>Folds of the patch</source>
        <translation>Fałdy łaty</translation>
    </message>
    <message>
        <source>Grasps of the patch</source>
        <translation>Chwyty łaty</translation>
    </message>
    <message>
        <source>Entries of the needle</source>
        <translation>Wkłucia igły</translation>
    </message>
    <message>
        <source>Needle taken again</source>
        <translation>Ponowne chwyty igły</translation>
    </message>
    <message>
        <source>Hand-overs of the needle</source>
        <translation>Przekazania igły</translation>
    </message>
    <message>
        <source>Needle let go between hands</source>
        <translation>Igła puszczona między rękami</translation>
    </message>
    <message>
        <source>Needle dropped</source>
        <translation>Upuszczenia igły</translation>
    </message>
    <message>
        <source>Needle held beside its place</source>
        <translation>Igła chwycona obok miejsca</translation>
    </message>
    <message>
        <source>Needle askew in the jaws</source>
        <translation>Igła skośnie w szczękach</translation>
    </message>
    <message>
        <source>Turning of the needle</source>
        <translation>Obracanie igły</translation>
    </message>
    <message>
        <source>Turn at a hand-over</source>
        <translation>Obrót przy przekazaniu</translation>
    </message>
    <message>
        <source>Force at a hand-over</source>
        <translation>Siła przy przekazaniu</translation>
    </message>
    <message>
        <source>Slips of the needle</source>
        <translation>Ześlizgi igły</translation>
    </message>
    <message>
        <source>Thread cut through</source>
        <translation>Przecięcia nicią</translation>
    </message>
    <message>
        <source>Contour followed</source>
        <translation>Przebyta linia</translation>
    </message>
    <message>
        <source>Distance from the line</source>
        <translation>Odległość od linii</translation>
    </message>
    <message>
        <source>Distance from the line, 95th percentile</source>
        <translation>Odległość od linii, 95. percentyl</translation>
    </message>
    <message>
        <source>Traction held</source>
        <translation>Utrzymane napięcie</translation>
    </message>
    <message>
        <source>Pull on the thread, loosest bite</source>
        <translation>Naciąg nici, najluźniejszy ścieg</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Czas</translation>
    </message>
    <message>
        <source>Ring completeness</source>
        <translation>Kompletność okręgu</translation>
    </message>
    <message>
        <source>Largest gap</source>
        <translation>Największa przerwa</translation>
    </message>
    <message>
        <source>Deviation from the plan</source>
        <translation>Odchylenie od planu</translation>
    </message>
    <message>
        <source>Deviation, 95th percentile</source>
        <translation>Odchylenie, 95. percentyl</translation>
    </message>
    <message>
        <source>Deviation, largest</source>
        <translation>Odchylenie największe</translation>
    </message>
    <message>
        <source>Deviation, signed</source>
        <translation>Odchylenie ze znakiem</translation>
    </message>
    <message>
        <source>Width of the kerf</source>
        <translation>Szerokość szczeliny cięcia</translation>
    </message>
    <message>
        <source>Length off the planned line</source>
        <translation>Długość poza planowaną linią</translation>
    </message>
    <message>
        <source>Length in healthy skin</source>
        <translation>Długość w zdrowej skórze</translation>
    </message>
    <message>
        <source>Length too near the placode</source>
        <translation>Długość zbyt blisko płytki</translation>
    </message>
    <message>
        <source>Placode contacts</source>
        <translation>Dotknięcia płytki</translation>
    </message>
    <message>
        <source>Placode contact time</source>
        <translation>Czas kontaktu z płytką</translation>
    </message>
    <message>
        <source>Peak force on the placode</source>
        <translation>Największa siła na płytce</translation>
    </message>
    <message>
        <source>Energised placode contact</source>
        <translation>Kontakt z płytką pod energią</translation>
    </message>
    <message>
        <source>Placode thermal dose</source>
        <translation>Dawka cieplna płytki</translation>
    </message>
    <message>
        <source>Placode peak temperature</source>
        <translation>Najwyższa temperatura płytki</translation>
    </message>
    <message>
        <source>Placode overheated</source>
        <translation>Przegrzanie płytki</translation>
    </message>
    <message>
        <source>Placode burned</source>
        <translation>Oparzenie płytki</translation>
    </message>
    <message>
        <source>Activations</source>
        <translation>Włączenia energii</translation>
    </message>
    <message>
        <source>Energy on</source>
        <translation>Czas z energią</translation>
    </message>
    <message>
        <source>Energy in the air</source>
        <translation>Energia poza tkanką</translation>
    </message>
    <message>
        <source>Activations in the air</source>
        <translation>Włączenia poza tkanką</translation>
    </message>
    <message>
        <source>Energy near the placode</source>
        <translation>Energia blisko płytki</translation>
    </message>
    <message>
        <source>Energy delivered</source>
        <translation>Energia oddana</translation>
    </message>
    <message>
        <source>Resting on one spot</source>
        <translation>Zatrzymanie w miejscu</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>Największa siła</translation>
    </message>
    <message>
        <source>Force above the scene's limit</source>
        <translation>Siła powyżej granicy sceny</translation>
    </message>
    <message>
        <source>Time above the scene's force limit</source>
        <translation>Czas z siłą powyżej granicy sceny</translation>
    </message>
    <message>
        <source>Tissue torn or taken out</source>
        <translation>Tkanka rozerwana lub usunięta</translation>
    </message>
    <message>
        <source>Skin torn or taken out</source>
        <translation>Skóra rozerwana lub usunięta</translation>
    </message>
    <message>
        <source>Burned skin</source>
        <translation>Wypalona skóra</translation>
    </message>
    <message>
        <source>Energy into healthy skin</source>
        <translation>Energia w zdrowej skórze</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>Długość drogi</translation>
    </message>
    <message>
        <source>Depth path</source>
        <translation>Droga w głąb</translation>
    </message>
    <message>
        <source>Angular path</source>
        <translation>Droga kątowa</translation>
    </message>
    <message>
        <source>Mean speed</source>
        <translation>Średnia prędkość</translation>
    </message>
    <message>
        <source>Movements</source>
        <translation>Liczba ruchów</translation>
    </message>
    <message>
        <source>Idle time</source>
        <translation>Czas bezruchu</translation>
    </message>
    <message>
        <source>Smoothness (SPARC)</source>
        <translation>Płynność (SPARC)</translation>
    </message>
    <message>
        <source>Times out of view</source>
        <translation>Wyjścia z pola widzenia</translation>
    </message>
    <message>
        <source>Share out of view</source>
        <translation>Udział poza polem widzenia</translation>
    </message>
    <message>
        <source>Idle share</source>
        <translation>Udział bezruchu</translation>
    </message>
    <message>
        <source>Rotation about the shaft</source>
        <translation>Obrót wokół trzonu</translation>
    </message>
    <message>
        <source>Pitch path</source>
        <translation>Droga kątowa w pionie</translation>
    </message>
    <message>
        <source>Yaw path</source>
        <translation>Droga kątowa w poziomie</translation>
    </message>
    <message>
        <source>Economy of cutting</source>
        <translation>Ekonomia cięcia</translation>
    </message>
    <message>
        <source>Economy of volume</source>
        <translation>Ekonomia objętości</translation>
    </message>
    <message>
        <source>Normalised jerk</source>
        <translation>Znormalizowany zryw</translation>
    </message>
    <message>
        <source>Speed peaks</source>
        <translation>Szczyty prędkości</translation>
    </message>
    <message>
        <source>Path length, left hand</source>
        <translation>Długość drogi, lewa ręka</translation>
    </message>
    <message>
        <source>Path length, right hand</source>
        <translation>Długość drogi, prawa ręka</translation>
    </message>
    <message>
        <source>Hands together</source>
        <translation>Zgodność rąk</translation>
    </message>
    <message>
        <source>Balance of hands</source>
        <translation>Równowaga rąk</translation>
    </message>
    <message>
        <source>Both hands moving</source>
        <translation>Ruch obu rąk</translation>
    </message>
    <message>
        <source>Tremor</source>
        <translation>Drżenie</translation>
    </message>
    <message>
        <source>Mean force</source>
        <translation>Średnia siła</translation>
    </message>
    <message>
        <source>RMS force</source>
        <translation>Siła skuteczna (RMS)</translation>
    </message>
    <message>
        <source>Impulse of force</source>
        <translation>Popęd siły</translation>
    </message>
    <message>
        <source>Impulse on the placode</source>
        <translation>Popęd siły na płytkę</translation>
    </message>
    <message>
        <source>Deviation, RMS</source>
        <translation>Odchylenie, RMS</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>Przerwy w nacięciu</translation>
    </message>
    <message>
        <source>Over-stretched</source>
        <translation>Nadmierne rozciągnięcia</translation>
    </message>
    <message>
        <source>Largest stretch</source>
        <translation>Największe rozciągnięcie</translation>
    </message>
    <message>
        <source>Over-stretched volume and time</source>
        <translation>Nadmiernie rozciągnięta objętość i czas</translation>
    </message>
    <message>
        <source>Thermal spread</source>
        <translation>Rozprzestrzenienie cieplne</translation>
    </message>
    <message>
        <source>Thermal spread, 95th percentile</source>
        <translation>Rozprzestrzenienie cieplne, 95. percentyl</translation>
    </message>
    <message>
        <source>Thermal spread, largest</source>
        <translation>Rozprzestrzenienie cieplne, największe</translation>
    </message>
    <message>
        <source>Spread of the thermal dose</source>
        <translation>Zasięg dawki cieplnej</translation>
    </message>
    <message>
        <source>Spread of the thermal dose, 95th percentile</source>
        <translation>Zasięg dawki cieplnej, 95. percentyl</translation>
    </message>
    <message>
        <source>Spread of the thermal dose, largest</source>
        <translation>Zasięg dawki cieplnej, największy</translation>
    </message>
    <message>
        <source>Smoothness (LDLJ-V)</source>
        <translation>Płynność (LDLJ-V)</translation>
    </message>
    <message>
        <source>Out of view</source>
        <translation>Poza obrazem</translation>
    </message>
    <message>
        <source>Placode released</source>
        <translation>Uwolnienie płytki</translation>
    </message>
    <message>
        <source>Placode cut by scissors</source>
        <translation>Płytka przecięta nożyczkami</translation>
    </message>
    <message>
        <source>Skin cut by scissors</source>
        <translation>Skóra przecięta nożyczkami</translation>
    </message>
    <message>
        <source>Snips</source>
        <translation>Cięcia nożyczkami</translation>
    </message>
    <message>
        <source>Pieces taken out</source>
        <translation>Wyjęte fragmenty</translation>
    </message>
    <message>
        <source>Resected tissue</source>
        <translation>Wycięta tkanka</translation>
    </message>
    <message>
        <source>Marked tissue resected</source>
        <translation>Wycięta oznaczona tkanka</translation>
    </message>
    <message>
        <source>Grasps</source>
        <translation>Uchwycenia</translation>
    </message>
    <message>
        <source>Held lifted</source>
        <translation>Czas uniesienia</translation>
    </message>
    <message>
        <source>Slips of the grasper</source>
        <translation>Wyślizgnięcia z chwytaka</translation>
    </message>
    <message>
        <source>Crushed</source>
        <translation>Zmiażdżenia</translation>
    </message>
    <message>
        <source>Pulled too hard</source>
        <translation>Zbyt silne pociągnięcia</translation>
    </message>
    <message>
        <source>Peak traction</source>
        <translation>Największa siła pociągania</translation>
    </message>
    <message>
        <source>Hausdorff distance</source>
        <translation>Odległość Hausdorffa</translation>
    </message>
    <message>
        <source>Placode heat damage</source>
        <translation>Uszkodzenie cieplne płytki</translation>
    </message>
    <message>
        <source>Smoothness (LDLJ)</source>
        <translation>Płynność (LDLJ, z prędkości)</translation>
    </message>
    <message>
        <source>Working volume</source>
        <translation>Objętość pracy</translation>
    </message>
    <message>
        <source>Economy of motion</source>
        <translation>Ekonomia ruchu</translation>
    </message>
    <message>
        <source>Translational actions</source>
        <translation>Ruchy przesuwne</translation>
    </message>
    <message>
        <source>Rotational actions</source>
        <translation>Ruchy obrotowe</translation>
    </message>
    <message>
        <source>Left hand alone moving</source>
        <translation>Ruch tylko lewej ręki</translation>
    </message>
    <message>
        <source>Right hand alone moving</source>
        <translation>Ruch tylko prawej ręki</translation>
    </message>
    <message>
        <source>No hand moving</source>
        <translation>Bez ruchu obu rąk</translation>
    </message>
    <message>
        <source>Hands turning together</source>
        <translation>Wspólny obrót rąk</translation>
    </message>
    <message>
        <source>Tremor, acceleration</source>
        <translation>Drżenie, przyspieszenie</translation>
    </message>
    <message>
        <source>Impulse above the scene's force limit</source>
        <translation>Popęd siły ponad granicę sceny</translation>
    </message>
    <message>
        <source>Marked tissue destroyed</source>
        <translation>Zniszczona oznaczona tkanka</translation>
    </message>
    <message>
        <source>Marked tissue gone</source>
        <translation>Ubytek oznaczonej tkanki</translation>
    </message>
    <message>
        <source>Tip stuck in tissue</source>
        <translation>Końcówka tkwiąca w tkance</translation>
    </message>
    <message>
        <source>Times stuck in tissue</source>
        <translation>Ile razy końcówka utkwiła w tkance</translation>
    </message>
    <message>
        <source>Placode removed or torn</source>
        <translation>Płytka usunięta lub rozerwana</translation>
    </message>
    <message>
        <source>Jet on the placode, highest pressure</source>
        <translation>Strumień na płytkę, najwyższe ciśnienie</translation>
    </message>
    <message>
        <source>Jet on the placode, above 500 Pa</source>
        <translation>Strumień na płytkę, ponad 500 Pa</translation>
    </message>
    <message>
        <source>Crumbs and blood washed off</source>
        <translation>Spłukane okruchy i krew</translation>
    </message>
    <message>
        <source>Fluid left standing</source>
        <translation>Pozostały płyn</translation>
    </message>
    <message>
        <source>Fluid used</source>
        <translation>Zużyty płyn</translation>
    </message>
    <message>
        <source>Lesion hidden by blood, at the end</source>
        <translation>Zmiana zasłonięta krwią, na końcu</translation>
    </message>
    <message>
        <source>Time with the lesion hidden</source>
        <translation>Czas z zasłoniętą zmianą</translation>
    </message>
    <message>
        <source>Suction on tissue</source>
        <translation>Ssak na tkance</translation>
    </message>
    <message>
        <source>Suction on the placode</source>
        <translation>Ssak na płytce</translation>
    </message>
    <message>
        <source>Skin freed, left</source>
        <translation>Uwolniona skóra, po lewej</translation>
    </message>
    <message>
        <source>Skin freed, right</source>
        <translation>Uwolniona skóra, po prawej</translation>
    </message>
    <message>
        <source>Undermined depth</source>
        <translation>Głębokość podminowania</translation>
    </message>
    <message>
        <source>Undermined too far</source>
        <translation>Podminowane za daleko</translation>
    </message>
    <message>
        <source>Torn fascia</source>
        <translation>Rozerwana powięź</translation>
    </message>
    <message>
        <source>Tension to close, before</source>
        <translation>Napięcie zamknięcia, przedtem</translation>
    </message>
    <message>
        <source>Tension to close, after</source>
        <translation>Napięcie zamknięcia, potem</translation>
    </message>
    <message>
        <source>Tension to close, share left</source>
        <translation>Napięcie zamknięcia, ile zostało</translation>
    </message>
</context>
<context>
    <name>MetricWords</name>
    <message>
        <source>Lower is better.</source>
        <translation>Mniej znaczy lepiej.</translation>
    </message>
    <message>
        <source>Higher is better.</source>
        <translation>Więcej znaczy lepiej.</translation>
    </message>
    <message>
        <source>Neither more nor less is better in itself.</source>
        <translation>Ani więcej, ani mniej nie jest samo w sobie lepsze.</translation>
    </message>
    <message>
        <source>Unit: %1.</source>
        <translation>Jednostka: %1.</translation>
    </message>
    <message>
        <source>Defined by this program.</source>
        <translation>Definicja tego programu.</translation>
    </message>
    <message>
        <source>Source: %1.</source>
        <translation>Źródło: %1.</translation>
    </message>
    <message>
        <source>The limit of this scene: %1 mN.</source>
        <translation>Granica tej sceny: %1 mN.</translation>
    </message>
</context>
<context>
    <name>MetricDefinition</name>
    <message>
        <source>From the first instrument in view to the end.</source>
        <translation>Od chwili, gdy pierwsze narzędzie jest w obrazie, do końca.</translation>
    </message>
    <message>
        <source>Mean distance of the kerf's centre from the planned contour.</source>
        <translation>Średnia odległość środka szczeliny cięcia od planowanej linii.</translation>
    </message>
    <message>
        <source>95th percentile of the distance of the kerf's centre from the planned contour.</source>
        <translation>95. percentyl odległości środka szczeliny cięcia od planowanej linii.</translation>
    </message>
    <message>
        <source>Largest distance of the kerf's centre from the planned contour.</source>
        <translation>Największa odległość środka szczeliny cięcia od planowanej linii.</translation>
    </message>
    <message>
        <source>Largest distance from the kerf's centre to the plan or from the plan to it.</source>
        <translation>Największa odległość środka szczeliny od planu lub planu od niej.</translation>
    </message>
    <message>
        <source>Mean signed distance: negative towards the placode, positive outwards.</source>
        <translation>Średnia odległość ze znakiem: ujemna w stronę płytki, dodatnia na zewnątrz.</translation>
    </message>
    <message>
        <source>Mean width of what was removed along the contour.</source>
        <translation>Średnia szerokość tego, co usunięto wzdłuż linii.</translation>
    </message>
    <message>
        <source>Length of the contour beside which tissue over 1 mm outside the skin edge was removed.</source>
        <translation>Długość linii, obok której usunięto tkankę ponad 1 mm na zewnątrz brzegu skóry.</translation>
    </message>
    <message>
        <source>Length of the contour beside which tissue within 0.5 mm of the placode was removed.</source>
        <translation>Długość linii, obok której usunięto tkankę bliżej niż 0,5 mm od płytki.</translation>
    </message>
    <message>
        <source>Times an instrument, needle or thread pressed on the placode with more than the force that the scene warns of.</source>
        <translation>Ile razy narzędzie, igła lub nić nacisnęły płytkę siłą większą niż ta, przed którą ostrzega scena.</translation>
    </message>
    <message>
        <source>Total time an instrument, needle or thread pressed on the placode with more than that force.</source>
        <translation>Łączny czas, w którym narzędzie, igła lub nić naciskały płytkę siłą większą od tej.</translation>
    </message>
    <message>
        <source>Largest contact force on the placode.</source>
        <translation>Największa siła nacisku na płytkę.</translation>
    </message>
    <message>
        <source>Time an energised instrument touched the placode, with whatever force.</source>
        <translation>Czas, w którym narzędzie pod prądem dotykało płytki, niezależnie od siły.</translation>
    </message>
    <message>
        <source>Largest thermal dose in the placode, equivalent minutes at 43 C, at most 1e6.</source>
        <translation>Największa dawka cieplna w płytce, w minutach równoważnych przy 43 °C, najwyżej 1e6.</translation>
    </message>
    <message>
        <source>Highest temperature in the placode.</source>
        <translation>Najwyższa temperatura w płytce.</translation>
    </message>
    <message>
        <source>Arrhenius integral of the placode's highest temperature with constants of skin: an upper bound, 1 = 63 % dead, at most 1e6.</source>
        <translation>Całka Arrheniusa z najwyższej temperatury płytki ze stałymi skóry: górne ograniczenie, 1 = 63 % martwych komórek, najwyżej 1e6.</translation>
    </message>
    <message>
        <source>Places of the placode, squares of 2 mm, where tissue passed the warning dose.</source>
        <translation>Miejsca płytki, kwadraty o boku 2 mm, w których tkanka przekroczyła dawkę ostrzegawczą.</translation>
    </message>
    <message>
        <source>Share of the placode's volume beyond the injury dose or temperature.</source>
        <translation>Część objętości płytki powyżej dawki lub temperatury uszkadzającej.</translation>
    </message>
    <message>
        <source>Volume of the placode that heat removed or stretch tore; pulling or pressing beside it tears it, too, without a contact.</source>
        <translation>Objętość płytki usunięta ciepłem lub rozerwana rozciąganiem; rozrywa ją też ciągnięcie lub nacisk obok niej, bez dotyku.</translation>
    </message>
    <message>
        <source>Times the energy was switched on.</source>
        <translation>Ile razy włączono prąd.</translation>
    </message>
    <message>
        <source>Time with the pedal down.</source>
        <translation>Czas z wciśniętym pedałem.</translation>
    </message>
    <message>
        <source>Time with the pedal down and no contact with tissue.</source>
        <translation>Czas z wciśniętym pedałem bez kontaktu z tkanką.</translation>
    </message>
    <message>
        <source>Times the pedal was down in the air for over 1 s; taps with pauses of up to 1 s count together.</source>
        <translation>Ile razy pedał był wciśnięty poza tkanką ponad 1 s; wciśnięcia z przerwami do 1 s liczą się razem.</translation>
    </message>
    <message>
        <source>Time with the pedal down and the tip within 1 mm of the placode, or over it.</source>
        <translation>Czas z wciśniętym pedałem i końcówką do 1 mm od płytki lub nad nią.</translation>
    </message>
    <message>
        <source>Energy that reached tissue.</source>
        <translation>Energia, która dotarła do tkanki.</translation>
    </message>
    <message>
        <source>Time of energy that stayed on one spot for over 1 s; taps with pauses of up to 1 s count together.</source>
        <translation>Czas z energią w jednym miejscu, jeśli trwała tam ponad 1 s; wciśnięcia pedału z przerwami do 1 s liczą się razem.</translation>
    </message>
    <message>
        <source>Largest force of an instrument on tissue.</source>
        <translation>Największa siła narzędzia działająca na tkankę.</translation>
    </message>
    <message>
        <source>Times the force was above the scene&apos;s limit, and once more for each 2 s that it was; a spell that begins within 3 s of the last one&apos;s end counts as the share of 3 s between them.</source>
        <translation>Ile razy siła przekroczyła granicę sceny, i jeszcze raz za każde 2 s przekroczenia; okres, który zaczyna się w ciągu 3 s od końca poprzedniego, liczy się jako ta część 3 s, która je dzieli.</translation>
    </message>
    <message>
        <source>Time with the force above the scene's limit.</source>
        <translation>Czas z siłą powyżej granicy sceny.</translation>
    </message>
    <message>
        <source>Undeformed volume of elements torn by stretch, and of tissue that left with a loose piece though it was not to go.</source>
        <translation>Objętość spoczynkowa elementów rozerwanych przez rozciąganie oraz tkanki, która odeszła z luźnym kawałkiem, choć miała zostać.</translation>
    </message>
    <message>
        <source>Undeformed volume of skin elements torn by stretch, and of healthy skin that left with a loose piece.</source>
        <translation>Objętość spoczynkowa elementów skóry rozerwanych przez rozciąganie oraz zdrowej skóry, która odeszła z luźnym kawałkiem.</translation>
    </message>
    <message>
        <source>Undeformed volume of skin that heat removed more than 1 mm outside the lesion&apos;s edge, however far from the plan.</source>
        <translation>Objętość spoczynkowa skóry usuniętej przez ciepło ponad 1 mm poza brzegiem zmiany, niezależnie od odległości od planu.</translation>
    </message>
    <message>
        <source>Energy that reached skin more than 1 mm outside the lesion&apos;s edge, whether it removed any or not.</source>
        <translation>Energia, która dotarła do skóry ponad 1 mm poza brzegiem zmiany, niezależnie od tego, czy coś usunęła.</translation>
    </message>
    <message>
        <source>Sectors of 5 degrees in which no tissue leads from the placode to the skin.</source>
        <translation>Wycinki po 5 stopni, w których żadna tkanka nie prowadzi od płytki do skóry.</translation>
    </message>
    <message>
        <source>Area over which scissors parted placode from placode.</source>
        <translation>Powierzchnia, na której nożyczki rozdzieliły płytkę.</translation>
    </message>
    <message>
        <source>Area of snips that went mostly through skin.</source>
        <translation>Powierzchnia cięć nożyczek, które przeszły głównie przez skórę.</translation>
    </message>
    <message>
        <source>Times that scissors closed on tissue.</source>
        <translation>Ile razy nożyczki zamknęły się na tkance.</translation>
    </message>
    <message>
        <source>Loose pieces drawn back to the port.</source>
        <translation>Luźne kawałki wycofane do portu.</translation>
    </message>
    <message>
        <source>Undeformed volume of these pieces.</source>
        <translation>Objętość spoczynkowa tych kawałków.</translation>
    </message>
    <message>
        <source>Times that jaws closed on tissue.</source>
        <translation>Ile razy szczęki zamknęły się na tkance.</translation>
    </message>
    <message>
        <source>Time during which held tissue was at least 0.7 mm above where it was grasped.</source>
        <translation>Czas, w którym trzymana tkanka była co najmniej 0,7 mm nad miejscem uchwycenia.</translation>
    </message>
    <message>
        <source>Times that tissue slid out of the jaws.</source>
        <translation>Ile razy tkanka wysunęła się ze szczęk.</translation>
    </message>
    <message>
        <source>Grasps with a jaw pressure above the tissue&apos;s limit, each once more for each 2 s that the jaws stayed shut as far.</source>
        <translation>Uchwycenia z naciskiem szczęk powyżej granicy tkanki, każde jeszcze raz za każde 2 s, w których szczęki były tak samo zaciśnięte.</translation>
    </message>
    <message>
        <source>Pulls above the tissue&apos;s limit for over 0.3 s, tugs with pauses of up to 0.3 s as one, and once more for each 2 s of them; one that begins within 3 s of the last one&apos;s end counts as the share of 3 s between them.</source>
        <translation>Pociągnięcia powyżej granicy tkanki trwające ponad 0,3 s, przy czym szarpnięcia z przerwami do 0,3 s to jedno, i jeszcze raz za każde ich 2 s; takie, które zaczyna się w ciągu 3 s od końca poprzedniego, liczy się jako ta część 3 s, która je dzieli.</translation>
    </message>
    <message>
        <source>Largest pull of held tissue on the jaws.</source>
        <translation>Największe pociągnięcie szczęk przez trzymaną tkankę.</translation>
    </message>
    <message>
        <source>Length of the paths of the instrument tips, filtered at 10 Hz, 100 Hz.</source>
        <translation>Droga końcówek narzędzi, filtr 10 Hz, 100 Hz.</translation>
    </message>
    <message>
        <source>Path of the tips along their own shafts.</source>
        <translation>Droga końcówek wzdłuż własnych trzonów.</translation>
    </message>
    <message>
        <source>Total rotation of the instruments.</source>
        <translation>Łączny obrót narzędzi.</translation>
    </message>
    <message>
        <source>Path length over time.</source>
        <translation>Długość drogi podzielona przez czas.</translation>
    </message>
    <message>
        <source>Times a tip's speed rose through 20 mm/s after having been below 10 mm/s.</source>
        <translation>Ile razy prędkość końcówki przekroczyła 20 mm/s po spadku poniżej 10 mm/s.</translation>
    </message>
    <message>
        <source>Time with all instruments below 1 mm/s and no pedal down.</source>
        <translation>Czas, w którym wszystkie narzędzia poruszały się wolniej niż 1 mm/s i żaden pedał nie był wciśnięty.</translation>
    </message>
    <message>
        <source>Spectral arc length, median over movements above 5 mm/s that last 0.3 s or more.</source>
        <translation>Długość łuku widma, mediana ruchów powyżej 5 mm/s trwających co najmniej 0,3 s.</translation>
    </message>
    <message>
        <source>Log dimensionless jerk of the vector velocity, median over the same movements.</source>
        <translation>Logarytm bezwymiarowego zrywu wektora prędkości, mediana tych samych ruchów.</translation>
    </message>
    <message>
        <source>Log dimensionless jerk of the speed, median over the same movements.</source>
        <translation>Logarytm bezwymiarowego zrywu prędkości, mediana tych samych ruchów.</translation>
    </message>
    <message>
        <source>Time that instrument tips were outside the picture.</source>
        <translation>Czas, w którym końcówki narzędzi były poza obrazem.</translation>
    </message>
    <message>
        <source>Times that an instrument tip left the picture.</source>
        <translation>Ile razy końcówka narzędzia opuściła obraz.</translation>
    </message>
    <message>
        <source>Share of the time that instrument tips were outside the picture.</source>
        <translation>Część czasu, w której końcówki narzędzi były poza obrazem.</translation>
    </message>
    <message>
        <source>Idle time over the whole time.</source>
        <translation>Czas bezruchu podzielony przez cały czas.</translation>
    </message>
    <message>
        <source>Total rotation of the instruments about their own shafts.</source>
        <translation>Łączny obrót narzędzi wokół własnych trzonów.</translation>
    </message>
    <message>
        <source>Total change of the shafts' direction up and down, seen from the first pose.</source>
        <translation>Łączna zmiana kierunku trzonów w górę i w dół, widziana z pierwszego położenia.</translation>
    </message>
    <message>
        <source>Total change of the shafts' direction to the sides, seen from the first pose.</source>
        <translation>Łączna zmiana kierunku trzonów na boki, widziana z pierwszego położenia.</translation>
    </message>
    <message>
        <source>Planned contour that was cut, over the path of the tip while energy was on.</source>
        <translation>Długość przeciętej części planowanej linii podzielona przez drogę końcówki z włączonym prądem.</translation>
    </message>
    <message>
        <source>Cube root of the box around the tip's path over its length, busiest instrument.</source>
        <translation>Pierwiastek sześcienny z objętości prostopadłościanu wokół drogi końcówki, podzielony przez długość tej drogi; narzędzie najczęściej używane.</translation>
    </message>
    <message>
        <source>Box around the path of the busiest instrument's tip.</source>
        <translation>Prostopadłościan wokół drogi końcówki najczęściej używanego narzędzia.</translation>
    </message>
    <message>
        <source>Straight lines over the paths of the tips, over the movements of SPARC.</source>
        <translation>Długość odcinków prostych podzielona przez drogę końcówek, w ruchach wziętych do SPARC.</translation>
    </message>
    <message>
        <source>Times a tip moved faster than 50 mm/s for over 0.2 s.</source>
        <translation>Ile razy końcówka poruszała się szybciej niż 50 mm/s ponad 0,2 s.</translation>
    </message>
    <message>
        <source>Times an instrument turned faster than 50 degrees a second for over 0.2 s.</source>
        <translation>Ile razy narzędzie obracało się szybciej niż 50 stopni na sekundę ponad 0,2 s.</translation>
    </message>
    <message>
        <source>Dimensionless root-squared jerk, median over the movements of SPARC; 19 at best.</source>
        <translation>Pierwiastek z kwadratu zrywu bez jednostki, mediana ruchów wziętych do SPARC; najlepszy wynik to 19.</translation>
    </message>
    <message>
        <source>Local maxima of the tips' speeds above 20 mm/s, per minute.</source>
        <translation>Lokalne maksima prędkości końcówek powyżej 20 mm/s, na minutę.</translation>
    </message>
    <message>
        <source>Way of the left hand's instrument.</source>
        <translation>Droga narzędzia lewej ręki.</translation>
    </message>
    <message>
        <source>Way of the right hand's instruments.</source>
        <translation>Droga narzędzi prawej ręki.</translation>
    </message>
    <message>
        <source>Correlation of the hands' speeds.</source>
        <translation>Korelacja prędkości rąk.</translation>
    </message>
    <message>
        <source>Shorter path divided by the longer one, of the two hands.</source>
        <translation>Krótsza z dróg obu rąk podzielona przez dłuższą.</translation>
    </message>
    <message>
        <source>Share of the time with both hands above 5 mm/s.</source>
        <translation>Część czasu, w której obie ręce poruszały się szybciej niż 5 mm/s.</translation>
    </message>
    <message>
        <source>Share of the time with the left hand alone above 5 mm/s.</source>
        <translation>Część czasu, w której tylko lewa ręka poruszała się szybciej niż 5 mm/s.</translation>
    </message>
    <message>
        <source>Share of the time with the right hand alone above 5 mm/s.</source>
        <translation>Część czasu, w której tylko prawa ręka poruszała się szybciej niż 5 mm/s.</translation>
    </message>
    <message>
        <source>Share of the time with no hand above 5 mm/s.</source>
        <translation>Część czasu, w której żadna ręka nie poruszała się szybciej niż 5 mm/s.</translation>
    </message>
    <message>
        <source>Correlation of the hands' angular speeds.</source>
        <translation>Korelacja prędkości kątowych rąk.</translation>
    </message>
    <message>
        <source>Root of the tip's power from 8 to 12 Hz, unfiltered, worst instrument.</source>
        <translation>Pierwiastek z mocy ruchu końcówki od 8 do 12 Hz, bez filtra, najgorsze narzędzie.</translation>
    </message>
    <message>
        <source>Root of the power of the tip's acceleration from 8 to 12 Hz, unfiltered, worst instrument.</source>
        <translation>Pierwiastek z mocy przyspieszenia końcówki od 8 do 12 Hz, bez filtra, najgorsze narzędzie.</translation>
    </message>
    <message>
        <source>Mean force of instruments on tissue while they touch it.</source>
        <translation>Średnia siła narzędzi działająca na tkankę podczas dotyku.</translation>
    </message>
    <message>
        <source>Root mean square of that force.</source>
        <translation>Średnia kwadratowa tej siły.</translation>
    </message>
    <message>
        <source>Force on tissue summed up over time.</source>
        <translation>Siła działająca na tkankę zsumowana w czasie.</translation>
    </message>
    <message>
        <source>What the force was above the scene's limit, summed up over time.</source>
        <translation>Nadmiar siły ponad granicę sceny zsumowany w czasie.</translation>
    </message>
    <message>
        <source>Force on the placode summed up over time.</source>
        <translation>Siła działająca na płytkę zsumowana w czasie.</translation>
    </message>
    <message>
        <source>Root mean square of the distance of the kerf's centre from the planned contour.</source>
        <translation>Średnia kwadratowa odległości środka szczeliny cięcia od planowanej linii.</translation>
    </message>
    <message>
        <source>Times that tissue was stretched beyond its injury limit.</source>
        <translation>Ile razy tkanka została rozciągnięta ponad granicę urazu.</translation>
    </message>
    <message>
        <source>Largest principal stretch beyond that limit, 1 = at rest.</source>
        <translation>Największe rozciągnięcie główne ponad tę granicę, 1 = w spoczynku.</translation>
    </message>
    <message>
        <source>Undeformed volume beyond its injury stretch times how long; only periods longer than 50 ms.</source>
        <translation>Objętość spoczynkowa rozciągnięta ponad granicę urazu razy czas, okresy ponad 50 ms.</translation>
    </message>
    <message>
        <source>Mean distance from the edge of the incision to where heat damage (Omega) falls to 1, on both sides, along rays across the plan.</source>
        <translation>Średnia odległość od brzegu nacięcia do miejsca, gdzie uszkodzenie cieplne (Omega) spada do 1, po obu stronach, wzdłuż promieni w poprzek planu.</translation>
    </message>
    <message>
        <source>95th percentile of that distance.</source>
        <translation>95. percentyl tej odległości.</translation>
    </message>
    <message>
        <source>Largest of these distances; 4 at most.</source>
        <translation>Największa z tych odległości; najwyżej 4.</translation>
    </message>
    <message>
        <source>Mean distance from the edge of the incision to where the dose falls to 240 equivalent minutes at 43 C.</source>
        <translation>Średnia odległość od brzegu nacięcia do miejsca, gdzie dawka spada do 240 minut równoważnych przy 43 °C.</translation>
    </message>
    <message>
        <source>Share of the task's steps that were done.</source>
        <translation>Część kroków zadania, które wykonano.</translation>
    </message>
    <message>
        <source>Mean distance from the target's centre where tissue was first touched, one touch a target.</source>
        <translation>Średnia odległość miejsca pierwszego dotknięcia tkanki od środka celu, jedno dotknięcie na cel.</translation>
    </message>
    <message>
        <source>Times that tissue was touched or grasped beside the target.</source>
        <translation>Ile razy dotknięto lub uchwycono tkankę obok celu.</translation>
    </message>
    <message>
        <source>Share of the planned contour along which the tip passed within 1 mm.</source>
        <translation>Część planowanej linii, wzdłuż której końcówka przeszła w odległości do 1 mm.</translation>
    </message>
    <message>
        <source>Mean distance of the tip from the planned contour over stretches of 5 degrees, of each its worst pass; beyond 3 mm a pass counts where the tip goes along the surface for over 0.3 s.</source>
        <translation>Średnia odległość końcówki od planowanej linii na odcinkach po 5 stopni, z każdego najgorsze przejście; dalej niż 3 mm przejście liczy się, gdy końcówka sunie po powierzchni dłużej niż 0,3 s.</translation>
    </message>
    <message>
        <source>95th percentile of that distance, over the same stretches.</source>
        <translation>95. percentyl tej odległości, na tych samych odcinkach.</translation>
    </message>
    <message>
        <source>Distance of the needle's last entry from its mark, along the tissue at rest.</source>
        <translation>Odległość ostatniego wkłucia igły od znaku, wzdłuż tkanki w spoczynku.</translation>
    </message>
    <message>
        <source>Distance of the needle's last exit from its mark, along the tissue at rest.</source>
        <translation>Odległość ostatniego wykłucia igły od znaku, wzdłuż tkanki w spoczynku.</translation>
    </message>
    <message>
        <source>Deepest place of the needle's channel below the surface at rest, last bite.</source>
        <translation>Najgłębsze miejsce kanału igły pod powierzchnią w spoczynku, ostatnie przejście.</translation>
    </message>
    <message>
        <source>Angle between the needle's path and the surface at rest where the last bite went in, 90 = upright.</source>
        <translation>Kąt między drogą igły a powierzchnią w spoczynku w miejscu wkłucia ostatniego ściegu, 90 = prostopadle.</translation>
    </message>
    <message>
        <source>Bites that came out, through which all of the needle was drawn, and whose thread is still in them.</source>
        <translation>Ściegi, w których igła wyszła i przeszła cała na wylot, a nić nadal w nich tkwi.</translation>
    </message>
    <message>
        <source>Share of a slit along which its edges stand at most 0.2 mm apart at the end, at the depth where they are nearest.</source>
        <translation>Część długości rozcięcia, na której jego brzegi są na końcu oddalone najwyżej o 0,2 mm, na tej głębokości, gdzie są najbliżej.</translation>
    </message>
    <message>
        <source>How far the edges of a slit stand apart at the end, at the depth where they are nearest: mean along the slit.</source>
        <translation>Na ile brzegi rozcięcia są na końcu oddalone od siebie, na tej głębokości, gdzie są najbliżej: średnia wzdłuż rozcięcia.</translation>
    </message>
    <message>
        <source>How far the edges of a slit stand apart at the end, at the depth where they are nearest: where it gapes most.</source>
        <translation>Na ile brzegi rozcięcia są na końcu oddalone od siebie, na tej głębokości, gdzie są najbliżej: w najszerszym miejscu.</translation>
    </message>
    <message>
        <source>What the slit as it is left would let through at a pressure of 6 cmH2O, were it cut right through: calculated for rigid walls from the gap along its length. Only where no pressure was put on it.</source>
        <translation>Ile płynu przepuściłoby rozcięcie, tak jak je zostawiono, przy ciśnieniu 6 cmH2O, gdyby przecięto je na wylot: obliczone dla sztywnych brzegów ze szczeliny wzdłuż rozcięcia. Tylko tam, gdzie nie badano go pod ciśnieniem.</translation>
    </message>
    <message>
        <source>What the slit lets through at the end when fluid below it stands at 6 cmH2O and presses its walls apart, hands off.</source>
        <translation>Ile płynu przepuszcza rozcięcie na końcu, gdy płyn pod nim ma ciśnienie 6 cmH2O i rozpycha brzegi, bez narzędzi.</translation>
    </message>
    <message>
        <source>What the slit lets through at the end when fluid below it stands at 12.5 cmH2O and presses its walls apart, hands off.</source>
        <translation>Ile płynu przepuszcza rozcięcie na końcu, gdy płyn pod nim ma ciśnienie 12,5 cmH2O i rozpycha brzegi, bez narzędzi.</translation>
    </message>
    <message>
        <source>Pressure below the slit at which more than 10 ml/min pass it, rounded down to 0.1; the test ends at 40 cmH2O.</source>
        <translation>Ciśnienie pod rozcięciem, przy którym przepływa ponad 10 ml/min, zaokrąglone w dół do 0,1; próba kończy się na 40 cmH2O.</translation>
    </message>
    <message>
        <source>Where the slit leaks most at 12.5 cmH2O, from its left end, or its upper one where it runs up and down: the worst place of the stretch between two bites that lets most through.</source>
        <translation>Gdzie rozcięcie najbardziej przecieka przy 12,5 cmH2O, licząc od lewego końca, a od górnego, gdy biegnie z góry na dół: najgorsze miejsce tego odcinka między ściegami, który przepuszcza najwięcej.</translation>
    </message>
    <message>
        <source>How many finished bites lie between that end of the slit and the stretch that leaks most at 12.5 cmH2O: 0 before the first bite, 1 between the first and the second, and so on.</source>
        <translation>Ile ukończonych ściegów leży między tym końcem rozcięcia a odcinkiem, który najbardziej przecieka przy 12,5 cmH2O: 0 przed pierwszym ściegiem, 1 między pierwszym a drugim i tak dalej.</translation>
    </message>
    <message>
        <source>Where most passes at the pressure at which the slit bursts, from its left end, or its upper one where it runs up and down; nothing where it holds to the end of the test.</source>
        <translation>Gdzie najwięcej przepływa przy ciśnieniu, przy którym szew puszcza, licząc od lewego końca, a od górnego, gdy rozcięcie biegnie z góry na dół; brak wartości, gdy szew wytrzymał do końca próby.</translation>
    </message>
    <message>
        <source>Largest distance of an entry from its mark, over the bites of a row.</source>
        <translation>Największa odległość wkłucia od znaku wśród ściegów szwu.</translation>
    </message>
    <message>
        <source>Largest distance of an exit from its mark, over the bites of a row.</source>
        <translation>Największa odległość wykłucia od znaku wśród ściegów szwu.</translation>
    </message>
    <message>
        <source>Depth of the shallowest bite of a row, below the surface at rest.</source>
        <translation>Głębokość najpłytszego ściegu szwu pod powierzchnią w spoczynku.</translation>
    </message>
    <message>
        <source>Depth of the deepest bite of a row, below the surface at rest.</source>
        <translation>Głębokość najgłębszego ściegu szwu pod powierzchnią w spoczynku.</translation>
    </message>
    <message>
        <source>Depth of the deepest bite of a row less that of the shallowest.</source>
        <translation>Głębokość najgłębszego ściegu szwu minus głębokość najpłytszego.</translation>
    </message>
    <message>
        <source>Mean distance between the middles of neighbouring bites, along the line.</source>
        <translation>Średnia odległość środków sąsiednich ściegów, wzdłuż linii.</translation>
    </message>
    <message>
        <source>Largest less smallest distance between neighbouring bites, along the line.</source>
        <translation>Największa minus najmniejsza odległość sąsiednich ściegów, wzdłuż linii.</translation>
    </message>
    <message>
        <source>Largest difference between the distances of a bite's entry and exit from the line.</source>
        <translation>Największa różnica odległości wkłucia i wykłucia jednego ściegu od linii.</translation>
    </message>
    <message>
        <source>Smallest angle between the needle's path and the surface at rest where it went in, over the bites of a row.</source>
        <translation>Najmniejszy kąt między drogą igły a powierzchnią w spoczynku w miejscu wkłucia, wśród ściegów szwu.</translation>
    </message>
    <message>
        <source>Times that the needle's point opened a surface from outside.</source>
        <translation>Ile razy ostrze igły przebiło powierzchnię od zewnątrz.</translation>
    </message>
    <message>
        <source>Times that jaws took the needle after the first.</source>
        <translation>Ile razy szczęki chwyciły igłę po pierwszym chwycie.</translation>
    </message>
    <message>
        <source>Times that the needle went to the other driver while both held it.</source>
        <translation>Ile razy igła przeszła do drugiego imadła, gdy trzymały ją oba.</translation>
    </message>
    <message>
        <source>Times that the other driver took the needle after it had been let go.</source>
        <translation>Ile razy drugie imadło chwyciło igłę dopiero po jej puszczeniu.</translation>
    </message>
    <message>
        <source>Times that the needle was let go in the open, and not to lie at its mark.</source>
        <translation>Ile razy igłę puszczono poza tkanką, i nie po to, by leżała przy znaku.</translation>
    </message>
    <message>
        <source>Largest distance between where jaws took the needle and where the step wanted it, as a share of its arc.</source>
        <translation>Największa odległość miejsca, w którym szczęki chwyciły igłę, od wymaganego w kroku, jako część łuku.</translation>
    </message>
    <message>
        <source>Largest angle between the wire and what is square to the driver, when jaws took it.</source>
        <translation>Największy kąt między drutem a prostopadłą do imadła w chwili chwytu.</translation>
    </message>
    <message>
        <source>How far the needle was turned in hands, in all, in steps of 2 degrees.</source>
        <translation>O ile łącznie obrócono igłę w rękach, w krokach po 2 stopnie.</translation>
    </message>
    <message>
        <source>Largest angle by which the needle turned while both drivers held it.</source>
        <translation>Największy kąt, o jaki obróciła się igła, gdy trzymały ją oba imadła.</translation>
    </message>
    <message>
        <source>Largest force between the drivers through the needle while both held it.</source>
        <translation>Największa siła między imadłami przez igłę, gdy trzymały ją oba.</translation>
    </message>
    <message>
        <source>Share of the placode's edge beyond which the patch reaches 5 mm or more, hands off.</source>
        <translation>Część brzegu płytki, poza którą łata sięga o 5 mm lub więcej, bez narzędzi.</translation>
    </message>
    <message>
        <source>How far the patch reaches beyond the placode's edge, hands off: mean along the edge, where more than 5 mm counts as 5.</source>
        <translation>Jak daleko łata sięga poza brzeg płytki, bez narzędzi: średnia wzdłuż brzegu, gdzie więcej niż 5 mm liczy się jako 5.</translation>
    </message>
    <message>
        <source>How far the patch reaches beyond the placode's edge, hands off, where it reaches least; 0 where it does not cover the edge, 10 at most.</source>
        <translation>Jak daleko łata sięga poza brzeg płytki, bez narzędzi, tam, gdzie sięga najmniej; 0, gdzie nie przykrywa brzegu, najwyżej 10.</translation>
    </message>
    <message>
        <source>Share of the placode that the patch does not cover, hands off.</source>
        <translation>Część płytki, której łata nie przykrywa, bez narzędzi.</translation>
    </message>
    <message>
        <source>Share of the patch that lies on another layer of it, or stands or turns more than 60 degrees away from the rest of it, hands off.</source>
        <translation>Część łaty, która leży na innej jej warstwie, stoi lub odwraca się o więcej niż 60 stopni od reszty, bez narzędzi.</translation>
    </message>
    <message>
        <source>Times that jaws closed on the patch, or on tissue instead of it.</source>
        <translation>Ile razy szczęki zamknęły się na łacie lub zamiast niej na tkance.</translation>
    </message>
    <message>
        <source>Times that the needle slid or turned in the jaws.</source>
        <translation>Ile razy igła przesunęła się lub obróciła w szczękach.</translation>
    </message>
    <message>
        <source>Times that the thread cut through the edge of its channel.</source>
        <translation>Ile razy nić przecięła brzeg swojego kanału.</translation>
    </message>
    <message>
        <source>Time during which both hands pulled within the task's limits.</source>
        <translation>Czas, w którym obie ręce ciągnęły w granicach zadania.</translation>
    </message>
    <message>
        <source>Hardest pull on the thread while the slit was shut, of the bite where it was least.</source>
        <translation>Największa siła, z jaką ciągnięto nić, gdy rozcięcie było zamknięte: w ściegu, w którym była najmniejsza.</translation>
    </message>
    <message>
        <source>Share of the marked volume that burned, tore or was washed away as crumbs.</source>
        <translation>Część oznaczonej objętości, która się spaliła, rozerwała lub została wypłukana jako okruchy.</translation>
    </message>
    <message>
        <source>Share of the marked volume that is no longer there, taken out or destroyed, as the picture shows it.</source>
        <translation>Część oznaczonej objętości, której już nie ma: wyciągnięta lub zniszczona, tak jak pokazuje obraz.</translation>
    </message>
    <message>
        <source>Time with the tip of an instrument inside tissue that it was pushed through; only periods longer than 0.3 s; a tip in a hole that was cut or torn is not stuck.</source>
        <translation>Czas, przez który końcówka tkwiła w tkance, przez którą ją przepchnięto, epizody ponad 0,3 s; końcówka w otworze naciętym lub rozerwanym nie tkwi.</translation>
    </message>
    <message>
        <source>Times that the tip of an instrument was inside tissue that it was pushed through for over 0.3 s.</source>
        <translation>Ile razy końcówka tkwiła ponad 0,3 s w tkance, przez którą ją przepchnięto.</translation>
    </message>
    <message>
        <source>Share of the planned contour's points that are cut through to the target depth within 1 mm, as the picture shows it.</source>
        <translation>Część punktów planowanej linii przeciętych na docelową głębokość w granicach 1 mm, tak jak pokazuje obraz.</translation>
    </message>
    <message>
        <source>Longest stretch of the planned contour without a point that is cut.</source>
        <translation>Najdłuższy odcinek planowanej linii bez przeciętego punktu.</translation>
    </message>
    <message>
        <source>Length of the incision whose centre is more than 0.5 mm off the plan, or that reaches into healthy skin or to the placode.</source>
        <translation>Długość nacięcia, którego środek leży ponad 0,5 mm od planu albo które sięga w zdrową skórę lub do płytki.</translation>
    </message>
    <message>
        <source>Share of the marked volume that was drawn out of the field in pieces; what burned, tore or was washed away does not count.</source>
        <translation>Część oznaczonej objętości wyciągnięta z pola w kawałkach; to, co spalone, rozerwane lub wypłukane, się nie liczy.</translation>
    </message>
    <message>
        <source>Stretches of the planned contour without a point that is cut.</source>
        <translation>Odcinki planowanej linii bez przeciętego punktu.</translation>
    </message>
    <message>
        <source>Highest pressure of the jet on the placode: 1/2 rho v^2, less with distance, beside its axis and aslant.</source>
        <translation>Najwyższe ciśnienie strumienia na płytkę: 1/2 rho v^2, mniejsze z odległością, obok osi i na ukos.</translation>
    </message>
    <message>
        <source>Time in which the jet pressed on the placode with more than 500 Pa.</source>
        <translation>Czas, w którym strumień uciskał płytkę ciśnieniem ponad 500 Pa.</translation>
    </message>
    <message>
        <source>Share of the crumbs of char and spots of blood that are out of the field at the end.</source>
        <translation>Część okruchów zwęglenia i plamek krwi, których na końcu nie ma już w polu.</translation>
    </message>
    <message>
        <source>Fluid that stands more than 0.2 mm deep at the end.</source>
        <translation>Płyn, który na końcu stoi głębiej niż 0,2 mm.</translation>
    </message>
    <message>
        <source>What the jet has given.</source>
        <translation>Ile płynu podał strumień.</translation>
    </message>
    <message>
        <source>Light that blood in the standing fluid takes, mean over the lesion, at the end.</source>
        <translation>Światło, które zabiera krew w stojącym płynie, średnio nad zmianą, na końcu.</translation>
    </message>
    <message>
        <source>Time in which blood in the standing fluid hid more than 30 % of the lesion.</source>
        <translation>Czas, w którym krew w stojącym płynie zasłaniała ponad 30 % zmiany.</translation>
    </message>
    <message>
        <source>Time in which tissue took more than half of the suction.</source>
        <translation>Czas, w którym tkanka przejmowała ponad połowę ssania.</translation>
    </message>
    <message>
        <source>Time in which the placode took more than half of the suction.</source>
        <translation>Czas, w którym płytka przejmowała ponad połowę ssania.</translation>
    </message>
    <message>
        <source>Share of the area to be freed beside the wound, on its left, that has come off the fascia.</source>
        <translation>Część pola do uwolnienia po lewej stronie rany, która odeszła od powięzi.</translation>
    </message>
    <message>
        <source>The same on its right.</source>
        <translation>To samo po prawej.</translation>
    </message>
    <message>
        <source>From the edges of the wound outwards to what still holds, mean of all lines.</source>
        <translation>Od brzegów rany na zewnątrz do miejsca, które jeszcze trzyma, średnio ze wszystkich linii.</translation>
    </message>
    <message>
        <source>Area that has come off the fascia farther from the edges than skin may be freed.</source>
        <translation>Pole, które odeszło od powięzi dalej od brzegów, niż wolno uwalniać skórę.</translation>
    </message>
    <message>
        <source>Undeformed volume of elements of fascia and muscle torn by stretch.</source>
        <translation>Objętość (bez odkształcenia) elementów powięzi i mięśnia rozerwanych rozciąganiem.</translation>
    </message>
    <message>
        <source>Force over length with which the edges of the untouched wound pull when they are drawn to the midline.</source>
        <translation>Siła na długość, z jaką ciągną brzegi nietkniętej rany ściągnięte do linii środkowej.</translation>
    </message>
    <message>
        <source>The same at the end, hands off.</source>
        <translation>To samo na końcu, po puszczeniu.</translation>
    </message>
    <message>
        <source>Tension to close at the end over that of the untouched wound.</source>
        <translation>Napięcie zamknięcia na końcu wobec napięcia nietkniętej rany.</translation>
    </message>
</context>
<context>
    <name>ParticipantPage</name>
    <message>
        <source>%1: a number from %2 to %3</source>
        <translation>%1: liczba od %2 do %3</translation>
    </message>
    <message>
        <source>Participant %1</source>
        <translation>Uczestnik badania %1</translation>
    </message>
    <message>
        <source>Leave without submitting?</source>
        <translation>Wyjść bez wysłania?</translation>
    </message>
    <message>
        <source>Leave without saving?</source>
        <translation>Wyjść bez zapisania?</translation>
    </message>
    <message>
        <source>The text was changed and neither published nor exported.</source>
        <translation>Tekst został zmieniony, a nie został ani opublikowany, ani wyeksportowany.</translation>
    </message>
    <message>
        <source>Stay here</source>
        <translation>Zostań tutaj</translation>
    </message>
    <message>
        <source>The answers given so far are not saved.</source>
        <translation>Dotychczasowe odpowiedzi nie są zapisane.</translation>
    </message>
    <message>
        <source>Go on answering</source>
        <translation>Odpowiadaj dalej</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Wyjdź</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Review the answers</source>
        <translation>Przejrzyj odpowiedzi</translation>
    </message>
    <message>
        <source> (may be left out)</source>
        <translation> (można pominąć)</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1: %2 z %3</translation>
    </message>
    <message>
        <source>does not apply</source>
        <translation>nie dotyczy</translation>
    </message>
    <message>
        <source>year-month-day, e.g. 2026-11-21</source>
        <translation>rok-miesiąc-dzień, np. 2026-11-21</translation>
    </message>
    <message>
        <source>not answered</source>
        <translation>bez odpowiedzi</translation>
    </message>
    <message>
        <source>answered</source>
        <translation>udzielono odpowiedzi</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Wybierz …</translation>
    </message>
    <message>
        <source>Question %1 needs an answer.</source>
        <translation>Pytanie %1 wymaga odpowiedzi.</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Przegląd</translation>
    </message>
    <message>
        <source>Nothing is saved yet. Go back to change an answer, or submit.</source>
        <translation>Nic jeszcze nie zapisano. Wróć, aby zmienić odpowiedź, albo wyślij.</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Zmień</translation>
    </message>
    <message>
        <source>Submit</source>
        <translation>Wyślij</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>Saving the answers</source>
        <translation>Zapis odpowiedzi</translation>
    </message>
    <message>
        <source>Thank you.</source>
        <translation>Dziękujemy.</translation>
    </message>
    <message>
        <source>The answers of %1 are saved. Please hand the screen back to the coordinator.</source>
        <translation>Odpowiedzi %1 są zapisane. Proszę oddać ekran koordynatorowi.</translation>
    </message>
    <message>
        <source>Back to the study</source>
        <translation>Powrót do badania</translation>
    </message>
    <message>
        <source>Rate an attempt</source>
        <translation>Oceń próbę</translation>
    </message>
    <message>
        <source>Saving the rating</source>
        <translation>Zapisywanie oceny</translation>
    </message>
    <message>
        <source>The rating is saved.</source>
        <translation>Ocena zapisana.</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Podgląd</translation>
    </message>
    <message>
        <source>Second entry of %1</source>
        <translation>Drugie wprowadzenie: %1</translation>
    </message>
    <message>
        <source>Preview: nothing is saved.</source>
        <translation>Podgląd: nic nie jest zapisywane.</translation>
    </message>
    <message>
        <source>Entry from paper of %1: type what the sheet says.</source>
        <translation>Wprowadzanie z papieru, %1: proszę wpisać to, co jest na arkuszu.</translation>
    </message>
    <message>
        <source>Second entry from paper of %1: the first one is not shown.</source>
        <translation>Drugie wprowadzenie z papieru, %1: pierwsze nie jest pokazywane.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>od %1 do %2</translation>
    </message>
    <message numerus="yes">
        <source>%n year(s)</source>
        <translation>
            <numerusform>%n rok</numerusform>
            <numerusform>%n lata</numerusform>
            <numerusform>%n lat</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 years</source>
        <comment>a number that is not whole</comment>
        <translation>%1 roku</translation>
    </message>
    <message>
        <source>Saving the second entry</source>
        <translation>Zapisywanie drugiego wprowadzenia</translation>
    </message>
    <message>
        <source>The second entry is saved; differences are listed below.</source>
        <translation>Drugie wprowadzenie zapisane; różnice są wymienione poniżej.</translation>
    </message>
    <message>
        <source>This question needs an answer.</source>
        <translation>To pytanie wymaga odpowiedzi.</translation>
    </message>
    <message>
        <source>Questions %1 need an answer.</source>
        <translation>Pytania %1 wymagają odpowiedzi.</translation>
    </message>
    <message>
        <source>%1: a date such as 2026-11-21</source>
        <translation>%1: data, na przykład 2026-11-21</translation>
    </message>
    <message>
        <source>%1: one of the answers that are offered</source>
        <translation>%1: jedna z podanych odpowiedzi</translation>
    </message>
</context>
<context>
    <name>Parts</name>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n punkt</numerusform>
            <numerusform>%n punkty</numerusform>
            <numerusform>%n punktów</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 points</source>
        <comment>with a tenth</comment>
        <translation>%1 punktu</translation>
    </message>
    <message>
        <source>DEMONSTRATION</source>
        <translation>DEMONSTRACJA</translation>
    </message>
    <message>
        <source>Made by a scripted operator or a demonstration account.</source>
        <translation>Wykonane przez program lub konto demonstracyjne.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Zaliczone</translation>
    </message>
    <message>
        <source>Failed: critical error</source>
        <translation>Niezaliczone: błąd krytyczny</translation>
    </message>
    <message>
        <source>Not yet</source>
        <translation>Jeszcze nie</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>zakończona</translation>
    </message>
    <message>
        <source>time limit</source>
        <translation>limit czasu</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>zatrzymana</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>przerwana</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>Uczestnik szkolenia</translation>
    </message>
    <message>
        <source>Educator</source>
        <translation>Instruktor</translation>
    </message>
    <message>
        <source>Coordinator</source>
        <translation>Koordynator</translation>
    </message>
    <message>
        <source>Administrator</source>
        <translation>Administrator</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Mysz</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Klawiatura</translation>
    </message>
    <message>
        <source>Gamepad</source>
        <translation>Pad</translation>
    </message>
    <message>
        <source>Scripted expert</source>
        <translation>Program: ekspert</translation>
    </message>
    <message>
        <source>Scripted intermediate</source>
        <translation>Program: średnio zaawansowany</translation>
    </message>
    <message>
        <source>Scripted novice</source>
        <translation>Program: początkujący</translation>
    </message>
    <message>
        <source>Does not count</source>
        <translation>Nie liczy się</translation>
    </message>
</context>
<context>
    <name>PeoplePage</name>
    <message>
        <source>Change the roles</source>
        <translation>Zmień role</translation>
    </message>
    <message>
        <source>Change the roles of %1?</source>
        <translation>Zmienić role: %1?</translation>
    </message>
    <message>
        <source>From now on: %1. Whoever is signed in with this account has to sign in again.</source>
        <translation>Od teraz: %1. Kto jest zalogowany na to konto, musi zalogować się ponownie.</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Zmień</translation>
    </message>
    <message>
        <source>%1 is now: %2.</source>
        <translation>%1 ma teraz role: %2.</translation>
    </message>
    <message>
        <source>The log-in name %1 is taken: %2 has it. Choose another one.</source>
        <translation>Login %1 jest zajęty: ma go %2. Wybierz inny.</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Osoby</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Imię i nazwisko</translation>
    </message>
    <message>
        <source>Log-in name</source>
        <translation>Login</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>Role</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stan</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Od</translation>
    </message>
    <message>
        <source>Add a person</source>
        <translation>Dodaj osobę</translation>
    </message>
    <message>
        <source>First password</source>
        <translation>Pierwsze hasło</translation>
    </message>
    <message>
        <source>Add the person</source>
        <translation>Dodaj osobę</translation>
    </message>
    <message>
        <source>Select a person to change the account.</source>
        <translation>Wybierz osobę, aby zmienić jej konto.</translation>
    </message>
    <message>
        <source>New password</source>
        <translation>Nowe hasło</translation>
    </message>
    <message>
        <source>Set password</source>
        <translation>Ustaw hasło</translation>
    </message>
    <message>
        <source>Deactivate</source>
        <translation>Wyłącz</translation>
    </message>
    <message>
        <source>Deactivated</source>
        <translation>Wyłączone</translation>
    </message>
    <message>
        <source>DEMONSTRATION</source>
        <translation>DEMONSTRACJA</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Włączone</translation>
    </message>
    <message>
        <source>Activate</source>
        <translation>Włącz</translation>
    </message>
    <message>
        <source>Adding the person</source>
        <translation>Dodawanie osoby</translation>
    </message>
    <message>
        <source>A person needs at least one role.</source>
        <translation>Osoba musi mieć co najmniej jedną rolę.</translation>
    </message>
    <message>
        <source>Setting the password</source>
        <translation>Ustawianie hasła</translation>
    </message>
    <message>
        <source>%1 has a new password.</source>
        <translation>%1 ma nowe hasło.</translation>
    </message>
    <message>
        <source>Deactivate %1?</source>
        <translation>Wyłączyć konto: %1?</translation>
    </message>
    <message>
        <source>The person can no longer sign in. Attempts and answers stay.</source>
        <translation>Ta osoba nie będzie mogła się zalogować. Próby i odpowiedzi pozostaną.</translation>
    </message>
    <message>
        <source>Changing the account</source>
        <translation>Zmiana konta</translation>
    </message>
    <message>
        <source>Invitations, lists, requests</source>
        <translation>Zaproszenia, listy, prośby</translation>
    </message>
    <message>
        <source>Invitations, lists, requests (%1 waiting)</source>
        <translation>Zaproszenia, listy, prośby (czeka: %1)</translation>
    </message>
    <message>
        <source>No role is ticked.</source>
        <translation>Nie zaznaczono żadnej roli.</translation>
    </message>
    <message>
        <source>Will be: %1</source>
        <translation>Będzie: %1</translation>
    </message>
    <message>
        <source>%1 was added: %2.</source>
        <translation>Dodano: %1 (%2).</translation>
    </message>
</context>
<context>
    <name>ProtocolCard</name>
    <message>
        <source>%1 is enrolled</source>
        <translation>%1: uczestnik włączony</translation>
    </message>
    <message>
        <source>Hand the screen over now? The participant answers and operates; you take it back with your password.</source>
        <translation>Przekazać teraz ekran? Uczestnik odpowiada i wykonuje zadania; odbierzesz go swoim hasłem.</translation>
    </message>
    <message>
        <source>Hand over</source>
        <translation>Przekaż</translation>
    </message>
    <message>
        <source>Not yet</source>
        <translation>Jeszcze nie</translation>
    </message>
    <message>
        <source>%1 is enrolled. &quot;Continue&quot; hands the screen over.</source>
        <translation>%1: uczestnik włączony. „Kontynuuj” przekazuje ekran.</translation>
    </message>
    <message>
        <source>Publish version %1</source>
        <translation>Opublikuj wersję %1</translation>
    </message>
    <message>
        <source>Publishing the study</source>
        <translation>Publikowanie badania</translation>
    </message>
    <message>
        <source>Version %1 · participants: %2</source>
        <translation>Wersja %1 · uczestnicy: %2</translation>
    </message>
    <message>
        <source>Enrol a participant</source>
        <translation>Włącz uczestnika</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Kod</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Kroki</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Następny</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Ostatnio</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Uwaga</translation>
    </message>
    <message>
        <source>Where everyone stands</source>
        <translation>Na jakim etapie są wszyscy</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>zakończone</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Kontynuuj</translation>
    </message>
    <message>
        <source>What becomes of the data</source>
        <translation>Co stanie się z danymi</translation>
    </message>
    <message>
        <source>use the data to date</source>
        <translation>używać dotychczasowych danych</translation>
    </message>
    <message>
        <source>use the data no more</source>
        <translation>nie używać już danych</translation>
    </message>
    <message>
        <source>erase the data</source>
        <translation>usunąć dane</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Powód</translation>
    </message>
    <message>
        <source>Reason, or: not given</source>
        <translation>Powód albo: nie podano</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>Wycofaj</translation>
    </message>
    <message>
        <source>Export format</source>
        <translation>Format eksportu</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Eksport</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Raport</translation>
    </message>
    <message>
        <source>Making a participant code</source>
        <translation>Tworzenie kodu uczestnika</translation>
    </message>
    <message>
        <source>Erase the data of %1?</source>
        <translation>Usunąć dane uczestnika %1?</translation>
    </message>
    <message>
        <source>Answers and attempts of the study are deleted. The code stays.</source>
        <translation>Odpowiedzi i próby z badania zostaną usunięte. Kod pozostanie.</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Usuń dane</translation>
    </message>
    <message>
        <source>Withdrawing %1</source>
        <translation>Wycofywanie %1</translation>
    </message>
    <message>
        <source>Export into this folder</source>
        <translation>Eksport do tego folderu</translation>
    </message>
    <message>
        <source>Exporting the study</source>
        <translation>Eksportowanie badania</translation>
    </message>
    <message>
        <source>Exporting the study: %1</source>
        <translation>Eksportowanie badania: %1</translation>
    </message>
    <message>
        <source>Exporting the study: %1, recording %2 of %3</source>
        <translation>Eksportowanie badania: %1, nagranie %2 z %3</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Zapisz raport</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Making the report</source>
        <translation>Tworzenie raportu</translation>
    </message>
    <message>
        <source>Report written: %1</source>
        <translation>Zapisano raport: %1</translation>
    </message>
    <message>
        <source>withdrew: %1</source>
        <translation>wycofani: %1</translation>
    </message>
    <message>
        <source>Reason to include what names a person</source>
        <translation>Powód dołączenia tego, co wskazuje osobę</translation>
    </message>
    <message>
        <source>Reason to include names; audited</source>
        <translation>Powód dołączenia nazwisk; zapisywany w dzienniku</translation>
    </message>
    <message>
        <source>Left empty, questions that name a person stay in the store. For who may see names only.</source>
        <translation>Gdy puste, pytania wskazujące osobę pozostają w bazie. Tylko dla osób uprawnionych do nazwisk.</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Dane</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Wyniki</translation>
    </message>
    <message>
        <source>Making the report: %1</source>
        <translation>Tworzenie raportu: %1</translation>
    </message>
    <message>
        <source>Version %1 came with this program. %2 Who is enrolled already keeps the version of that day.</source>
        <translation>Z tym programem przyszła wersja %1. %2 Kto jest już włączony, zachowuje wersję z tamtego dnia.</translation>
    </message>
    <message>
        <source>Device of the participant</source>
        <translation>Urządzenie uczestnika</translation>
    </message>
    <message>
        <source>With what the participant works; it cannot be changed in the run.</source>
        <translation>Czym pracuje uczestnik; w trakcie nie można tego zmienić.</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Urządzenie</translation>
    </message>
    <message>
        <source>Procedures</source>
        <translation>Zabiegi</translation>
    </message>
    <message>
        <source>Handing the screen over</source>
        <translation>Przekazanie ekranu</translation>
    </message>
    <message>
        <source>An export with names needs a reason of at least %1 characters.</source>
        <translation>Eksport z nazwiskami wymaga uzasadnienia o długości co najmniej %1 znaków.</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s), read back and compared with the store: %1</source>
        <translation>
            <numerusform>%n plik, odczytany i porównany z bazą: %1</numerusform>
            <numerusform>%n pliki, odczytane i porównane z bazą: %1</numerusform>
            <numerusform>%n plików, odczytanych i porównanych z bazą: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Not published yet. Publishing keeps this protocol for good; a change is a new version with a reason. Check the consent text first.</source>
        <translation>Jeszcze nieopublikowany. Publikacja zachowuje ten protokół na zawsze; zmiana to nowa wersja z podaniem przyczyny. Najpierw sprawdź tekst zgody.</translation>
    </message>
    <message>
        <source>The protocol that came with this program carries version %1: those before it were replaced before anybody published them here.</source>
        <translation>Protokół dostarczony z programem ma wersję %1: wcześniejsze zastąpiono, zanim ktoś je tu opublikował.</translation>
    </message>
    <message>
        <source>Check the consent text</source>
        <translation>Sprawdź tekst zgody</translation>
    </message>
    <message>
        <source>Withdraw %1?</source>
        <translation>Wycofać uczestnika %1?</translation>
    </message>
    <message>
        <source>The run ends here for good. The data to date may be used.</source>
        <translation>Badanie tego uczestnika kończy się na dobre. Dotychczasowe dane mogą być używane.</translation>
    </message>
    <message>
        <source>The run ends here for good. The data are used no more.</source>
        <translation>Badanie tego uczestnika kończy się na dobre. Dane nie będą już używane.</translation>
    </message>
</context>
<context>
    <name>RatingsPage</name>
    <message>
        <source>Ratings</source>
        <translation>Oceny</translation>
    </message>
    <message>
        <source>Watch an attempt and judge it with the OSATS form. Name and score are hidden until the rating is saved; every rater gets another order.</source>
        <translation>Obejrzyj próbę i oceń ją formularzem OSATS. Nazwisko i wynik są ukryte do zapisania oceny; każdy oceniający ma inną kolejność.</translation>
    </message>
    <message>
        <source>To be rated: %1</source>
        <translation>Do oceny: %1</translation>
    </message>
    <message>
        <source>Nothing waits for your rating.</source>
        <translation>Nic nie czeka na Twoją ocenę.</translation>
    </message>
    <message>
        <source>Next: %1, %2</source>
        <translation>Następna: %1, %2</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Obejrzyj</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Oceń</translation>
    </message>
    <message>
        <source>Agreement of raters</source>
        <translation>Zgodność oceniających</translation>
    </message>
    <message>
        <source>Two raters have to rate the same two attempts before agreement can be told.</source>
        <translation>Dwie osoby muszą ocenić te same dwie próby, zanim można podać zgodność.</translation>
    </message>
    <message>
        <source>ICC(2,1) %1, 95 % interval %2 to %3; mean of the raters ICC(2,k) %4 (attempts %5, raters %6)</source>
        <translation>ICC(2,1) %1, przedział 95 % od %2 do %3; średnia oceniających ICC(2,k) %4 (próby %5, oceniający %6)</translation>
    </message>
    <message>
        <source>These ratings carry no ICC: they do not vary.</source>
        <translation>Z tych ocen nie da się obliczyć ICC: nie różnią się.</translation>
    </message>
    <message>
        <source>Fewer than 10 attempts: the interval says how little this tells.</source>
        <translation>Mniej niż 10 prób: przedział pokazuje, jak niewiele to mówi.</translation>
    </message>
    <message>
        <source>Two-way random effects, absolute agreement (Shrout and Fleiss 1979).</source>
        <translation>Dwuczynnikowy model losowy, zgodność bezwzględna (Shrout i Fleiss 1979).</translation>
    </message>
    <message>
        <source>Ratings beside the score</source>
        <translation>Oceny obok wyniku</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Osoba</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Zadanie</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkty</translation>
    </message>
    <message>
        <source>Global rating (1 to 5)</source>
        <translation>Ocena ogólna (1 do 5)</translation>
    </message>
    <message>
        <source>Raters</source>
        <translation>Oceniający</translation>
    </message>
    <message>
        <source>With five rated attempts the correlation with the score is told.</source>
        <translation>Korelacja z wynikiem zostanie podana przy pięciu ocenionych próbach.</translation>
    </message>
    <message>
        <source>Spearman's rho between score and rating: %1, 95 % interval %2 to %3 (n = %4)</source>
        <translation>Rho Spearmana między wynikiem a oceną: %1, przedział 95 % od %2 do %3 (n = %4)</translation>
    </message>
</context>
<context>
    <name>Reason</name>
    <message>
        <source>Tissue or generator was tuned: this attempt is not scored as a pass.</source>
        <translation>Tkankę lub generator strojono: tej próby nie ocenia się jako zaliczonej.</translation>
    </message>
    <message>
        <source>once</source>
        <translation>raz</translation>
    </message>
    <message>
        <source>twice</source>
        <translation>dwa razy</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 razy</translation>
    </message>
    <message>
        <source> at %1 o'clock</source>
        <translation> na godzinie %1</translation>
    </message>
    <message>
        <source> between bites %1 and %2</source>
        <translation> między ściegami %1 i %2</translation>
    </message>
    <message>
        <source> between the left end and bite %1</source>
        <translation> między lewym końcem a ściegiem %1</translation>
    </message>
    <message>
        <source> between the upper end and bite %1</source>
        <translation> między górnym końcem a ściegiem %1</translation>
    </message>
    <message>
        <source> between bite %1 and the right end</source>
        <translation> między ściegiem %1 a prawym końcem</translation>
    </message>
    <message>
        <source> between bite %1 and the lower end</source>
        <translation> między ściegiem %1 a dolnym końcem</translation>
    </message>
    <message>
        <source>Not recorded, so this is no pass: {metric}.</source>
        <translation>Nie zapisano, więc próba nie jest zaliczona: {metric}.</translation>
    </message>
    <message>
        <source>It could not be measured and counts in full: {metric}.</source>
        <translation>Nie dało się zmierzyć i liczy się w całości: {metric}.</translation>
    </message>
    <message>
        <source>Nothing was done: this attempt does not count.</source>
        <translation>Nic nie zrobiono: ta próba się nie liczy.</translation>
    </message>
    <message>
        <source>Not scored: begun at stage {value}, what came before was given.</source>
        <translation>Bez oceny: rozpoczęto od etapu {value}, to, co przedtem, było gotowe.</translation>
    </message>
</context>
<context>
    <name>RecoveryPage</name>
    <message>
        <source>%1 of %2 (%3) waits for the server. It is saved by itself when that is back.</source>
        <translation>%1 z %2 (%3) czeka na serwer. Zapisze się sama, gdy wróci.</translation>
    </message>
    <message>
        <source>The recording is there already: choose another folder.</source>
        <translation>To nagranie już tam jest: wybierz inny folder.</translation>
    </message>
    <message>
        <source>Copy it to another disk</source>
        <translation>Skopiuj na inny dysk</translation>
    </message>
    <message>
        <source>Copy the recording</source>
        <translation>Kopiowanie nagrania</translation>
    </message>
    <message>
        <source>Recording (*.placode)</source>
        <translation>Nagranie (*.placode)</translation>
    </message>
    <message>
        <source>Copying the recording</source>
        <translation>Kopiowanie nagrania</translation>
    </message>
    <message>
        <source>Recording copied: %1</source>
        <translation>Skopiowano nagranie: %1</translation>
    </message>
    <message>
        <source>Attempts that were not finished</source>
        <translation>Niedokończone próby</translation>
    </message>
    <message>
        <source>Everything up to half a second before the end is in the recording.</source>
        <translation>Nagranie zawiera wszystko do pół sekundy przed końcem.</translation>
    </message>
    <message>
        <source>Nothing is left to recover.</source>
        <translation>Nie ma nic do odzyskania.</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Odzyskiwanie</translation>
    </message>
    <message>
        <source>Belongs to %1.</source>
        <translation>Należy do: %1.</translation>
    </message>
    <message>
        <source>Nobody knows whose it is. Save it for</source>
        <translation>Nie wiadomo, czyje to nagranie. Zapisz dla</translation>
    </message>
    <message>
        <source>Recording of %1</source>
        <translation>Nagranie z %1</translation>
    </message>
    <message>
        <source>%1 of %2 (%3) was finished but could not be saved. Save it now?</source>
        <translation>%1 z %2 (%3): próba zakończona, ale niezapisana. Zapisać teraz?</translation>
    </message>
    <message>
        <source>%1 of %2 was not finished (%3). Save it as interrupted?</source>
        <translation>%1 z %2: próba niedokończona (%3). Zapisać jako przerwaną?</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Zapisz</translation>
    </message>
    <message>
        <source>Keep for later</source>
        <translation>Zostaw na później</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Delete this recording?</source>
        <translation>Usunąć to nagranie?</translation>
    </message>
    <message>
        <source>The attempt is lost for good.</source>
        <translation>Próba przepadnie na zawsze.</translation>
    </message>
    <message>
        <source>Deleting the recording</source>
        <translation>Usuwanie nagrania</translation>
    </message>
    <message>
        <source>Saving the attempt</source>
        <translation>Zapis próby</translation>
    </message>
    <message>
        <source>Nothing had been recorded; the empty file was removed.</source>
        <translation>Nic nie nagrano; pusty plik usunięto.</translation>
    </message>
    <message>
        <source>The attempt was saved.</source>
        <translation>Próba została zapisana.</translation>
    </message>
    <message>
        <source>A recording</source>
        <translation>Nagranie</translation>
    </message>
    <message>
        <source>This is an exam: it is saved and uses up this attempt.</source>
        <translation>To jest egzamin: próba zostanie zapisana i zużyta.</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>numer %1</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Wybierz …</translation>
    </message>
</context>
<context>
    <name>ResultPage</name>
    <message>
        <source>from %1</source>
        <translation>od: %1</translation>
    </message>
    <message>
        <source>stage %1</source>
        <translation>etap %1</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Wstecz</translation>
    </message>
    <message>
        <source>To the page before (Alt and left arrow)</source>
        <translation>Do poprzedniej strony (Alt i strzałka w lewo)</translation>
    </message>
    <message>
        <source>This attempt failed; mastered in the course before: %1.</source>
        <translation>Ta próba jest niezaliczona; w kursie zaliczono już wcześniej: %1.</translation>
    </message>
    <message>
        <source>Mastered in the course: %1.</source>
        <translation>Zaliczono w kursie: %1.</translation>
    </message>
    <message>
        <source>The losses add up to %1 points; a score does not go below 0.</source>
        <translation>Straty dają razem %1 pkt; wynik nie spada poniżej 0.</translation>
    </message>
    <message>
        <source>No score: %1</source>
        <translation>Bez wyniku: %1</translation>
    </message>
    <message>
        <source>The attempt is kept.</source>
        <translation>Próba jest zachowana.</translation>
    </message>
    <message>
        <source>Close other programs, make the window of the simulation smaller, or use another computer.</source>
        <translation>Zamknij inne programy, zmniejsz okno symulacji albo użyj innego komputera.</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Wynik</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Raport</translation>
    </message>
    <message>
        <source>Write a PDF of this attempt</source>
        <translation>Zapisz PDF tej próby</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Jeszcze raz</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Dalej</translation>
    </message>
    <message>
        <source>No points were lost</source>
        <translation>Bez straty punktów</translation>
    </message>
    <message>
        <source>What failed the attempt, then what cost most</source>
        <translation>Co przesądziło o wyniku, potem co kosztowało najwięcej</translation>
    </message>
    <message>
        <source>What cost most</source>
        <translation>Co kosztowało najwięcej</translation>
    </message>
    <message>
        <source>Nothing in the rubric took points off.</source>
        <translation>Żadne kryterium nie odjęło punktów.</translation>
    </message>
    <message>
        <source>critical error</source>
        <translation>błąd krytyczny</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>w chwili %1</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>Pomiary</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Pomiar</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wartość</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Jednostka</translation>
    </message>
    <message>
        <source>Own last</source>
        <translation>Poprzednio</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Zmiana</translation>
    </message>
    <message>
        <source>= same</source>
        <translation>= tak samo</translation>
    </message>
    <message>
        <source>▲ better</source>
        <translation>▲ lepiej</translation>
    </message>
    <message>
        <source>▼ worse</source>
        <translation>▼ gorzej</translation>
    </message>
    <message>
        <source>The incision</source>
        <translation>Nacięcie</translation>
    </message>
    <message>
        <source>Reading the recording …</source>
        <translation>Odczyt nagrania …</translation>
    </message>
    <message>
        <source>Reading the recording</source>
        <translation>Odczyt nagrania</translation>
    </message>
    <message>
        <source>The recording cannot be shown.</source>
        <translation>Nie można pokazać nagrania.</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Zapisz raport</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Zapis raportu</translation>
    </message>
    <message>
        <source>Report written: %1</source>
        <translation>Raport zapisany: %1</translation>
    </message>
    <message>
        <source>All measures</source>
        <translation>Wszystkie pomiary</translation>
    </message>
    <message>
        <source>Only what counts</source>
        <translation>Tylko to, co się liczy</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Pokaż</translation>
    </message>
    <message>
        <source>Show the moment %1</source>
        <translation>Pokaż chwilę %1</translation>
    </message>
    <message>
        <source>no points lost</source>
        <translation>bez straty punktów</translation>
    </message>
    <message>
        <source>−%1 points</source>
        <translation>−%1 pkt</translation>
    </message>
    <message>
        <source>before: none lost</source>
        <translation>przedtem: bez strat</translation>
    </message>
    <message>
        <source>before: −%1</source>
        <translation>przedtem: −%1</translation>
    </message>
    <message>
        <source>Other reasons: %1, together −%2 points</source>
        <translation>Pozostałe powody: %1, razem −%2 pkt</translation>
    </message>
    <message>
        <source>Strengths and weaknesses</source>
        <translation>Mocne i słabe strony</translation>
    </message>
    <message>
        <source>The task is not installed here, so its rubric is unknown.</source>
        <translation>Tego zadania tu nie zainstalowano, więc jego kryteria nie są znane.</translation>
    </message>
    <message>
        <source>Damage over time</source>
        <translation>Uszkodzenia w czasie</translation>
    </message>
    <message>
        <source>Choose an entry to read what happened.</source>
        <translation>Wybierz wpis, aby przeczytać, co się stało.</translation>
    </message>
    <message>
        <source>Own band of %1</source>
        <translation>Własny zakres: %1</translation>
    </message>
    <message>
        <source>Own band</source>
        <translation>Własny zakres</translation>
    </message>
    <message>
        <source>Click a measure to read what it means and where it is from.</source>
        <translation>Kliknij miarę, aby przeczytać, co oznacza i skąd pochodzi.</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Obejrzyj</translation>
    </message>
    <message>
        <source>See this attempt again in the simulator's window</source>
        <translation>Obejrzyj tę próbę ponownie w oknie symulatora</translation>
    </message>
    <message>
        <source>%1 o'clock, %2: %3</source>
        <translation>godzina %1, %2: %3</translation>
    </message>
    <message>
        <source>No damage was recorded.</source>
        <translation>Nie zapisano żadnego uszkodzenia.</translation>
    </message>
    <message>
        <source>Where it happened</source>
        <translation>Gdzie to się stało</translation>
    </message>
    <message>
        <source>Damage</source>
        <translation>Uszkodzenia</translation>
    </message>
    <message>
        <source>Energy in tissue</source>
        <translation>Energia w tkance</translation>
    </message>
    <message>
        <source>Where the needle delivered energy, in joules per square millimetre.</source>
        <translation>Gdzie igła oddała energię, w dżulach na milimetr kwadratowy.</translation>
    </message>
    <message>
        <source>The field from above: planned contour, what was cut, the needle's path. The measures say the same in numbers.</source>
        <translation>Pole z góry: planowany kontur, co nacięto, droga igły. Pomiary mówią to samo w liczbach.</translation>
    </message>
    <message>
        <source>Paths of the instruments</source>
        <translation>Drogi narzędzi</translation>
    </message>
    <message>
        <source>Ways from above</source>
        <translation>Drogi z góry</translation>
    </message>
    <message>
        <source>Ways from the left side</source>
        <translation>Drogi z lewej strony</translation>
    </message>
    <message>
        <source>Ways from the feet</source>
        <translation>Drogi od strony stóp</translation>
    </message>
    <message>
        <source>Path length and time stand among the measures.</source>
        <translation>Długość drogi i czas są wśród pomiarów.</translation>
    </message>
    <message>
        <source>Thick where energy flowed into tissue.</source>
        <translation>Grubo tam, gdzie energia płynęła do tkanki.</translation>
    </message>
    <message>
        <source>Dashed line: the plan.</source>
        <translation>Linia przerywana: plan.</translation>
    </message>
    <message>
        <source>The force device did not work as it must: forces of this attempt may have been wrong.</source>
        <translation>Urządzenie haptyczne nie działało prawidłowo: siły w tej próbie mogły być błędne.</translation>
    </message>
    <message>
        <source>Haptic certificate: sound.</source>
        <translation>Certyfikat haptyczny: w porządku.</translation>
    </message>
    <message>
        <source>mean %1, SD %2, from %3 to %4, n = %5</source>
        <translation>średnia %1, SD %2, od %3 do %4, n = %5</translation>
    </message>
    <message>
        <source>Expert band</source>
        <translation>Eksperci</translation>
    </message>
    <message>
        <source>Novice band</source>
        <translation>Początkujący</translation>
    </message>
    <message>
        <source>Band: %1</source>
        <translation>Pasmo: %1</translation>
    </message>
    <message>
        <source>Bands of experts and novices: norm pack of %1, %2.</source>
        <translation>Pasma ekspertów i początkujących: pakiet norm %1, %2.</translation>
    </message>
    <message>
        <source>Exam</source>
        <translation>Egzamin</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Porównaj</translation>
    </message>
    <message>
        <source>See this attempt beside another one</source>
        <translation>Zobacz tę próbę obok innej</translation>
    </message>
    <message>
        <source>This attempt was kept without a recording. Score, reasons and measures are complete; the pictures, the report and watching it again need one.</source>
        <translation>Ta próba została zapisana bez nagrania. Wynik, powody i pomiary są kompletne; nagrania wymagają tylko obrazy, raport i ponowne obejrzenie.</translation>
    </message>
    <message>
        <source>Study %1</source>
        <translation>Badanie %1</translation>
    </message>
    <message>
        <source>Nothing was done that could be judged. Begin the first step of the task: from then on this card says what went well and what to practise.</source>
        <translation>Nie zrobiono nic, co można ocenić. Zacznij pierwszy krok zadania: od tej chwili ta karta powie, co się udało i co ćwiczyć.</translation>
    </message>
    <message>
        <source>The rubric of this task judges nothing that belongs here.</source>
        <translation>Kryteria tego zadania nie oceniają nic, co by tu należało.</translation>
    </message>
    <message numerus="yes">
        <source>before: mean of the last %n attempt(s)</source>
        <translation>
            <numerusform>przedtem: ostatnia próba</numerusform>
            <numerusform>przedtem: średnia z ostatnich %n prób</numerusform>
            <numerusform>przedtem: średnia z ostatnich %n prób</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Own band: mean and standard deviation of your last %n attempt(s) before this one; the dot is this attempt.</source>
        <translation>
            <numerusform>Własny zakres: ostatnia próba przed tą; kropka to ta próba.</numerusform>
            <numerusform>Własny zakres: średnia i odchylenie standardowe z ostatnich %n prób przed tą; kropka to ta próba.</numerusform>
            <numerusform>Własny zakres: średnia i odchylenie standardowe z ostatnich %n prób przed tą; kropka to ta próba.</numerusform>
        </translation>
    </message>
    <message>
        <source>Does not count: %1</source>
        <translation>Nie liczy się: %1</translation>
    </message>
    <message>
        <source>The force device did not work as it must (%1).</source>
        <translation>Urządzenie haptyczne nie działało prawidłowo (%1).</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>This was not your fault.</source>
        <translation>To nie Twoja wina.</translation>
    </message>
    <message>
        <source>The machine was the cause, not the person.</source>
        <translation>Przyczyną był sprzęt, nie osoba.</translation>
    </message>
    <message>
        <source>The attempt is kept, and does not count for the course.</source>
        <translation>Próba zostaje zapisana i nie liczy się w kursie.</translation>
    </message>
    <message>
        <source>What was noticed (not scored)</source>
        <translation>Co zauważono (bez oceny)</translation>
    </message>
    <message>
        <source>More: %1</source>
        <translation>Więcej: %1</translation>
    </message>
    <message>
        <source>The attempt is kept, and uses up an attempt of this exam.</source>
        <translation>Próba zostaje zachowana i zużywa jedną próbę tego egzaminu.</translation>
    </message>
    <message>
        <source>The attempt is kept, and uses up no attempt of this exam; the next one has another case, if there is one.</source>
        <translation>Próba zostaje zachowana i nie zużywa próby tego egzaminu; następna ma inny przypadek, jeśli taki jest.</translation>
    </message>
    <message>
        <source>The planned line; green where the tip followed it within 1 mm.</source>
        <translation>Linia planowana; zielona tam, gdzie końcówka szła po niej z dokładnością do 1 mm.</translation>
    </message>
    <message>
        <source>Places done: %1 of %2. Touches beside them: %3.</source>
        <translation>Wykonane miejsca: %1 z %2. Dotknięcia obok nich: %3.</translation>
    </message>
    <message>
        <source>The line to follow</source>
        <translation>Linia do obwiedzenia</translation>
    </message>
    <message>
        <source>The places of the task</source>
        <translation>Miejsca z zadania</translation>
    </message>
    <message>
        <source>What the hands did is simulated again, behind other work. The attempt gets its score and counts once the same comes out.</source>
        <translation>Ruchy rąk są symulowane ponownie, w tle. Próba otrzyma ocenę i będzie się liczyć, gdy wynik okaże się taki sam.</translation>
    </message>
    <message>
        <source>Simulated again</source>
        <translation>Ponowna symulacja</translation>
    </message>
    <message>
        <source>Simulated again: %1 %</source>
        <translation>Ponowna symulacja: %1 %</translation>
    </message>
    <message>
        <source>To the course</source>
        <translation>Do kursu</translation>
    </message>
    <message>
        <source>It was recorded by another version of Placode, or on another kind of processor, and can be simulated again only there. Until that is done it does not count.</source>
        <translation>Nagrano ją inną wersją Placode lub na procesorze innego rodzaju i tylko tam można ją symulować ponownie. Do tego czasu się nie liczy.</translation>
    </message>
    <message>
        <source>It waits for &quot;%1&quot;; this is &quot;%2&quot;.</source>
        <translation>Czeka na „%1”; to jest „%2”.</translation>
    </message>
</context>
<context>
    <name>RunningPage</name>
    <message>
        <source>It takes longer than usual: %1 so far.</source>
        <translation>Trwa to dłużej niż zwykle: dotąd %1.</translation>
    </message>
    <message>
        <source>End the attempt?</source>
        <translation>Zakończyć próbę?</translation>
    </message>
    <message>
        <source>It ends here, after %1, and is scored for what was done.</source>
        <translation>Kończy się tutaj, po %1, i zostanie oceniona za to, co zrobiono.</translation>
    </message>
    <message>
        <source>What was done is scored, or the attempt stays in the history as interrupted and does not count for the course.</source>
        <translation>Wykonana część zostaje oceniona albo próba zostaje w historii jako przerwana i nie liczy się do kursu.</translation>
    </message>
    <message>
        <source>Attempt is running</source>
        <translation>Próba trwa</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Czas</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Etap</translation>
    </message>
    <message>
        <source>Pictures a second</source>
        <translation>Obrazy na sekundę</translation>
    </message>
    <message>
        <source>This computer is too slow: the attempt will not count.</source>
        <translation>Ten komputer jest za wolny: próba nie będzie się liczyć.</translation>
    </message>
    <message>
        <source>Ring cut</source>
        <translation>Nacięty okrąg</translation>
    </message>
    <message>
        <source>Finish and score</source>
        <translation>Zakończ i oceń</translation>
    </message>
    <message>
        <source>Leave without finishing</source>
        <translation>Wyjdź bez kończenia</translation>
    </message>
    <message>
        <source>Go on operating</source>
        <translation>Operuj dalej</translation>
    </message>
    <message>
        <source>Leave the attempt?</source>
        <translation>Opuścić próbę?</translation>
    </message>
    <message>
        <source>What was done stays in the history as interrupted and does not count for the course.</source>
        <translation>Wykonana część zostaje w historii jako przerwana i nie liczy się do kursu.</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>Oględziny</translation>
    </message>
    <message>
        <source>Incise</source>
        <translation>Nacięcie</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Uwolnienie</translation>
    </message>
    <message>
        <source>Resect</source>
        <translation>Wycięcie</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Kontrola</translation>
    </message>
    <message>
        <source>Runs in the fetoscope's window: %1.</source>
        <translation>Trwa w oknie fetoskopu: %1.</translation>
    </message>
    <message>
        <source>The fetoscope's window is opening.</source>
        <translation>Otwiera się okno fetoskopu.</translation>
    </message>
    <message>
        <source>The recording lost entries: %1. The attempt will not count.</source>
        <translation>Nagranie straciło wpisy: %1. Próba nie będzie się liczyć.</translation>
    </message>
    <message>
        <source>Exam</source>
        <translation>Egzamin</translation>
    </message>
    <message>
        <source>Proctor: %1</source>
        <translation>Nadzór: %1</translation>
    </message>
    <message>
        <source>The procedure ends in the fetoscope's window, by itself or from its menu. What is ended here ends for good.</source>
        <translation>Zabieg kończy się w oknie fetoskopu, sam lub z menu. Co zakończy się tutaj, jest zakończone na dobre.</translation>
    </message>
    <message>
        <source>End the procedure</source>
        <translation>Zakończ zabieg</translation>
    </message>
    <message>
        <source>Break off</source>
        <translation>Przerwij</translation>
    </message>
    <message>
        <source>Break the procedure off?</source>
        <translation>Przerwać zabieg?</translation>
    </message>
    <message>
        <source>What was done so far is kept and does not count; the procedure has to be done again from the beginning.</source>
        <translation>To, co zrobiono, jest zachowane i nie liczy się; zabieg trzeba wykonać od początku.</translation>
    </message>
    <message>
        <source>The procedure has not begun yet: nothing is kept.</source>
        <translation>Zabieg jeszcze się nie zaczął: nic nie zostanie zapisane.</translation>
    </message>
    <message>
        <source>The exam has not begun yet: leaving uses up nothing.</source>
        <translation>Egzamin jeszcze się nie zaczął: wyjście niczego nie zużywa.</translation>
    </message>
    <message>
        <source>The attempt has not begun yet: nothing is kept.</source>
        <translation>Próba jeszcze się nie zaczęła: nic nie zostanie zapisane.</translation>
    </message>
    <message>
        <source>The procedure ends here for good, after %1. You cannot go on with it.</source>
        <translation>Zabieg kończy się tu na dobre, po %1. Nie można go kontynuować.</translation>
    </message>
    <message>
        <source>The exam ends here for good, after %1, and is scored as it is. You cannot go on with it.</source>
        <translation>Egzamin kończy się tu na dobre, po %1, i jest oceniany tak, jak jest. Nie można go kontynuować.</translation>
    </message>
    <message>
        <source>It lasted less than %1: it will not count and has to be done again.</source>
        <translation>Trwał krócej niż %1: nie będzie się liczył i trzeba go powtórzyć.</translation>
    </message>
    <message>
        <source>End the procedure?</source>
        <translation>Zakończyć zabieg?</translation>
    </message>
    <message>
        <source>End the exam?</source>
        <translation>Zakończyć egzamin?</translation>
    </message>
    <message>
        <source>End the exam</source>
        <translation>Zakończ egzamin</translation>
    </message>
    <message>
        <source>Scoring the attempt</source>
        <translation>Ocena próby</translation>
    </message>
    <message>
        <source>The attempt has ended.</source>
        <translation>Próba jest zakończona.</translation>
    </message>
    <message>
        <source>The procedure is over and is being saved.</source>
        <translation>Zabieg jest zakończony i zapisywany.</translation>
    </message>
    <message>
        <source>The attempt is over. Its recording is measured and scored; the result opens by itself.</source>
        <translation>Próba jest zakończona. Jej nagranie jest mierzone i oceniane; wynik otworzy się sam.</translation>
    </message>
    <message>
        <source>%1 so far.</source>
        <translation>Trwa już %1.</translation>
    </message>
    <message>
        <source>About %1 left.</source>
        <translation>Jeszcze około %1.</translation>
    </message>
    <message>
        <source>This is an exam: leaving uses up this attempt.</source>
        <translation>To jest egzamin: wyjście zużywa tę próbę.</translation>
    </message>
    <message>
        <source>The exam ends here and is scored as it is, or it is left, which uses up this attempt, too.</source>
        <translation>Egzamin kończy się tutaj i jest oceniany taki, jaki jest; wyjście bez kończenia także zużywa tę próbę.</translation>
    </message>
</context>
<context>
    <name>SetupPage</name>
    <message>
        <source>The first account</source>
        <translation>Pierwsze konto</translation>
    </message>
    <message>
        <source>The administrator adds people, keeps backups and reads the audit list.</source>
        <translation>Administrator dodaje osoby, pilnuje kopii i czyta dziennik.</translation>
    </message>
    <message>
        <source>Create the administrator</source>
        <translation>Utwórz administratora</translation>
    </message>
    <message>
        <source>First start</source>
        <translation>Pierwsze uruchomienie</translation>
    </message>
    <message>
        <source>I also train here (trainee)</source>
        <translation>Ja też tu ćwiczę (uczestnik szkolenia)</translation>
    </message>
    <message>
        <source>Add demonstration accounts to look around</source>
        <translation>Dodaj konta demonstracyjne, aby się rozejrzeć</translation>
    </message>
    <message>
        <source>demo.trainee, demo.educator, demo.coordinator, each with the password "%1"; their data is marked as demonstration everywhere.</source>
        <translation>demo.trainee, demo.educator, demo.coordinator, każde z hasłem „%1”; ich dane są wszędzie oznaczone jako demonstracja.</translation>
    </message>
    <message>
        <source>Creating the administrator</source>
        <translation>Tworzenie administratora</translation>
    </message>
    <message>
        <source>The administrator was created. Sign in to add people.</source>
        <translation>Administrator został utworzony. Zaloguj się, aby dodać osoby.</translation>
    </message>
    <message>
        <source>Demonstration trainee</source>
        <translation>Uczestnik demonstracyjny</translation>
    </message>
    <message>
        <source>Demonstration educator</source>
        <translation>Instruktor demonstracyjny</translation>
    </message>
    <message>
        <source>Demonstration coordinator</source>
        <translation>Koordynator demonstracyjny</translation>
    </message>
</context>
<context>
    <name>StandardsPage</name>
    <message>
        <source>No attempt at this task counts yet. Once some do, whoever made them stands here; the list above has other tasks.</source>
        <translation>Żadna próba tego zadania jeszcze się nie liczy. Gdy będą takie, ich autorzy staną tutaj; inne zadania są na liście u góry.</translation>
    </message>
    <message>
        <source>Reading the attempts</source>
        <translation>Odczyt prób</translation>
    </message>
    <message>
        <source>Standards</source>
        <translation>Progi</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Zadanie</translation>
    </message>
    <message>
        <source>A pass mark from two groups: choose who is a novice and who is an expert at this task. Each person counts once, with the mean of the last %1 attempts.</source>
        <translation>Próg zaliczenia z dwóch grup: wskaż, kto w tym zadaniu jest początkującym, a kto ekspertem. Każda osoba liczy się raz, średnią z ostatnich prób (liczba prób: %1).</translation>
    </message>
    <message>
        <source>There are no attempts yet.</source>
        <translation>Nie ma jeszcze prób.</translation>
    </message>
    <message>
        <source>Leave without setting the standard?</source>
        <translation>Wyjść bez ustalenia standardu?</translation>
    </message>
    <message>
        <source>What the judges have estimated is lost.</source>
        <translation>Oszacowania sędziów przepadną.</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Wyjdź</translation>
    </message>
    <message>
        <source>Stay here</source>
        <translation>Zostań tutaj</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Grupy</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Osoba</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Próby</translation>
    </message>
    <message>
        <source>Mean of the last</source>
        <translation>Średnia ostatnich</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupa</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Uwaga</translation>
    </message>
    <message>
        <source>DEMONSTRATION</source>
        <translation>DEMONSTRACJA</translation>
    </message>
    <message>
        <source>novice</source>
        <translation>początkujący</translation>
    </message>
    <message>
        <source>expert</source>
        <translation>ekspert</translation>
    </message>
    <message>
        <source>Contrasting groups</source>
        <translation>Grupy kontrastowe</translation>
    </message>
    <message>
        <source>Choose at least two novices and two experts.</source>
        <translation>Wskaż co najmniej dwóch początkujących i dwóch ekspertów.</translation>
    </message>
    <message>
        <source>These groups give no pass mark: their scores do not vary, or do not differ in the right direction.</source>
        <translation>Z tych grup nie wynika próg: wyniki nie różnią się wewnątrz grup albo między nimi w dobrym kierunku.</translation>
    </message>
    <message>
        <source>Pass mark: %1 points</source>
        <translation>Próg zaliczenia: %1 pkt</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Co</translation>
    </message>
    <message>
        <source>From the curves</source>
        <translation>Z krzywych</translation>
    </message>
    <message>
        <source>Observed</source>
        <translation>Zaobserwowane</translation>
    </message>
    <message>
        <source>What the pass mark costs</source>
        <translation>Ile kosztuje próg</translation>
    </message>
    <message>
        <source>Novices who would pass</source>
        <translation>Początkujący, którzy by zaliczyli</translation>
    </message>
    <message>
        <source>Experts who would fail</source>
        <translation>Eksperci, którzy by nie zaliczyli</translation>
    </message>
    <message>
        <source>AUC %1, Cohen's d %2, Mann-Whitney p %3. Method: Jorgensen, Konge and Subhi 2018.</source>
        <translation>AUC %1, d Cohena %2, p Manna-Whitneya %3. Metoda: Jorgensen, Konge i Subhi 2018.</translation>
    </message>
    <message>
        <source>Fewer than %1 people in a group: a first orientation, not a standard.</source>
        <translation>Mniej osób w grupie niż %1: wstępna orientacja, nie próg.</translation>
    </message>
    <message>
        <source>The standard that holds</source>
        <translation>Obowiązujący standard</translation>
    </message>
    <message>
        <source>Pass mark %1 points, version %2, set by %3 on %4</source>
        <translation>Próg zaliczenia %1 pkt, wersja %2, ustalił(a) %3, %4</translation>
    </message>
    <message>
        <source>None was set: the task's own pass mark of %1 points holds.</source>
        <translation>Nie ustalono: obowiązuje własny próg zadania, %1 pkt.</translation>
    </message>
    <message>
        <source>Reason (needed from the second one on)</source>
        <translation>Powód (wymagany od drugiego)</translation>
    </message>
    <message>
        <source>Set as the standard</source>
        <translation>Ustal jako standard</translation>
    </message>
    <message>
        <source>Name of this centre</source>
        <translation>Nazwa tego ośrodka</translation>
    </message>
    <message>
        <source>Make a norm pack of these groups</source>
        <translation>Utwórz pakiet norm z tych grup</translation>
    </message>
    <message>
        <source>Setting the standard</source>
        <translation>Ustalanie standardu</translation>
    </message>
    <message>
        <source>The standard is set (version %1). Attempts from now on are judged by it; earlier ones keep their verdict.</source>
        <translation>Standard ustalony (wersja %1). Według niego oceniane są próby od teraz; wcześniejsze zachowują ocenę.</translation>
    </message>
    <message>
        <source>Making the norm pack</source>
        <translation>Tworzenie pakietu norm</translation>
    </message>
    <message>
        <source>The norm pack is made and signed. It stands on the page Norms.</source>
        <translation>Pakiet norm utworzono i podpisano. Jest na stronie Normy.</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>numer %1</translation>
    </message>
    <message>
        <source>Mark people (Ctrl or Shift for several), then:</source>
        <translation>Zaznacz osoby (Ctrl lub Shift: kilka), potem:</translation>
    </message>
    <message>
        <source>Novices</source>
        <translation>Początkujący</translation>
    </message>
    <message>
        <source>Experts</source>
        <translation>Eksperci</translation>
    </message>
    <message>
        <source>Neither</source>
        <translation>Żadna z grup</translation>
    </message>
    <message numerus="yes">
        <source>From the estimates of %n judge(s), standard error %1 points. %2</source>
        <translation>
            <numerusform>Z oszacowań %n sędziego, błąd standardowy %1 pkt. %2</numerusform>
            <numerusform>Z oszacowań %n sędziów, błąd standardowy %1 pkt. %2</numerusform>
            <numerusform>Z oszacowań %n sędziów, błąd standardowy %1 pkt. %2</numerusform>
        </translation>
    </message>
    <message>
        <source>Novices: %1, experts: %2; novices who pass: %3 by the curves, %4 observed. %5</source>
        <translation>Początkujący: %1, eksperci: %2; początkujący powyżej progu: %3 z krzywych, %4 zaobserwowano. %5</translation>
    </message>
    <message>
        <source>Who was marked as a novice or an expert is forgotten.</source>
        <translation>Oznaczenia początkujących i ekspertów przepadną.</translation>
    </message>
</context>
<context>
    <name>StudiesPage</name>
    <message>
        <source>Studies</source>
        <translation>Badania</translation>
    </message>
    <message>
        <source>Questionnaire</source>
        <translation>Kwestionariusz</translation>
    </message>
    <message>
        <source>New participant</source>
        <translation>Nowy uczestnik badania</translation>
    </message>
    <message>
        <source>Placode gives a code without a name. Hand over the screen; the participant answers, reviews and submits.</source>
        <translation>Placode nadaje kod bez nazwiska. Oddaj ekran; uczestnik odpowiada, przegląda i wysyła.</translation>
    </message>
    <message>
        <source>Making a participant code</source>
        <translation>Nadawanie kodu uczestnika</translation>
    </message>
    <message>
        <source>Answers by item</source>
        <translation>Odpowiedzi według pytań</translation>
    </message>
    <message>
        <source>Export format</source>
        <translation>Format eksportu</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Eksportuj</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>Pozycja</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Pytanie</translation>
    </message>
    <message>
        <source>n</source>
        <translation>n</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Średnia</translation>
    </message>
    <message>
        <source>SD</source>
        <translation>SD</translation>
    </message>
    <message>
        <source>First answers of each participant to version %1, without those whose data are used no more. SD is the sample standard deviation (n − 1); missing answers are left out.</source>
        <translation>Pierwsze odpowiedzi każdego uczestnika na wersję %1, bez osób, których danych już się nie używa. SD to odchylenie standardowe z próby (n − 1); brakujące odpowiedzi są pominięte.</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Kod</translation>
    </message>
    <message>
        <source>Answered</source>
        <translation>Wypełniono</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Wersja</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Odpowiedzi</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Uwaga</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Uczestnicy</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>DEMONSTRATION</source>
        <translation>DEMONSTRACJA</translation>
    </message>
    <message>
        <source>Export into this folder</source>
        <translation>Eksportuj do tego folderu</translation>
    </message>
    <message>
        <source>Exporting the answers</source>
        <translation>Eksport odpowiedzi</translation>
    </message>
    <message>
        <source>Questionnaires without a protocol</source>
        <translation>Kwestionariusze bez protokołu</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s), read back and compared with the store: %1</source>
        <translation>
            <numerusform>%n plik, odczytany i porównany z bazą: %1</numerusform>
            <numerusform>%n pliki, odczytane i porównane z bazą: %1</numerusform>
            <numerusform>%n plików, odczytanych i porównanych z bazą: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Give this questionnaire</source>
        <translation>Daj ten kwestionariusz</translation>
    </message>
    <message>
        <source>Answered this questionnaire: %1</source>
        <translation>Odpowiedzi na ten kwestionariusz: %1</translation>
    </message>
    <message>
        <source>Nobody has answered this questionnaire yet.</source>
        <translation>Nikt jeszcze nie odpowiedział na ten kwestionariusz.</translation>
    </message>
</context>
<context>
    <name>StudyRunPage</name>
    <message>
        <source>One moment: the procedure begins when what is being saved is saved.</source>
        <translation>Chwileczkę: zabieg zacznie się, gdy zapis się zakończy.</translation>
    </message>
    <message>
        <source>Participant %1 · step %2 of %3</source>
        <translation>Uczestnik %1 · krok %2 z %3</translation>
    </message>
    <message>
        <source>Interrupt, back to the study</source>
        <translation>Przerwij, wróć do badania</translation>
    </message>
    <message>
        <source>Participant %1</source>
        <translation>Uczestnik %1</translation>
    </message>
    <message>
        <source>Read, go on</source>
        <translation>Przeczytane, dalej</translation>
    </message>
    <message>
        <source>Answer the questions</source>
        <translation>Odpowiedz na pytania</translation>
    </message>
    <message>
        <source>I consent</source>
        <translation>Wyrażam zgodę</translation>
    </message>
    <message>
        <source>Recording the consent</source>
        <translation>Zapisywanie zgody</translation>
    </message>
    <message>
        <source>A window with the fetoscope's view opens.</source>
        <translation>Otworzy się okno z obrazem fetoskopu.</translation>
    </message>
    <message>
        <source>It closes by itself after %1.</source>
        <translation>Zamknie się samo po %1.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Rozpocznij</translation>
    </message>
    <message>
        <source>Not needed, go on</source>
        <translation>Niepotrzebne, dalej</translation>
    </message>
    <message>
        <source>Starting the attempt</source>
        <translation>Rozpoczynanie próby</translation>
    </message>
    <message>
        <source>Thank you.</source>
        <translation>Dziękujemy.</translation>
    </message>
    <message>
        <source>Everything is done. Please hand the screen back to the coordinator.</source>
        <translation>Wszystko zrobione. Proszę oddać ekran koordynatorowi.</translation>
    </message>
    <message>
        <source>Back to the study</source>
        <translation>Wróć do badania</translation>
    </message>
    <message>
        <source>Recording the step</source>
        <translation>Zapisywanie kroku</translation>
    </message>
    <message>
        <source>Signed on paper; the coordinator keeps the sheet</source>
        <translation>Podpisano na papierze; arkusz przechowuje koordynator</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Wyczyść</translation>
    </message>
    <message>
        <source>Signature</source>
        <translation>Podpis</translation>
    </message>
    <message>
        <source>An attempt shorter than %1 does not count.</source>
        <translation>Próba krótsza niż %1 nie liczy się.</translation>
    </message>
    <message>
        <source>The attempt before does not count: %1. Please do this step once more.</source>
        <translation>Poprzednia próba się nie liczy: %1. Proszę wykonać ten krok jeszcze raz.</translation>
    </message>
    <message>
        <source>No device is chosen. Please call the coordinator.</source>
        <translation>Nie wybrano urządzenia. Proszę zawołać koordynatora.</translation>
    </message>
    <message>
        <source>Device: %1</source>
        <translation>Urządzenie: %1</translation>
    </message>
    <message>
        <source>I want to stop</source>
        <translation>Chcę przerwać</translation>
    </message>
    <message>
        <source>I do not consent</source>
        <translation>Nie wyrażam zgody</translation>
    </message>
    <message>
        <source>You do not consent?</source>
        <translation>Nie wyrażasz zgody?</translation>
    </message>
    <message>
        <source>You take no part, and nothing of you is used. You need not give a reason. Please hand the screen back to the coordinator afterwards.</source>
        <translation>Nie bierzesz udziału i żadne Twoje dane nie są używane. Nie trzeba podawać przyczyny. Potem proszę oddać ekran koordynatorowi.</translation>
    </message>
    <message>
        <source>Stop taking part?</source>
        <translation>Zakończyć udział?</translation>
    </message>
    <message>
        <source>Your run ends here for good. You need not give a reason. Tell the coordinator whether your data to date may be used, are used no more, or are erased.</source>
        <translation>Twój udział kończy się tu na dobre. Nie trzeba podawać przyczyny. Powiedz koordynatorowi, czy dotychczasowe dane mogą być używane, mają nie być używane, czy mają zostać usunięte.</translation>
    </message>
    <message>
        <source>Ending the run</source>
        <translation>Kończenie udziału</translation>
    </message>
    <message>
        <source>Your run has ended; nothing more is recorded. Please hand the screen back to the coordinator.</source>
        <translation>Udział jest zakończony; nic więcej nie jest zapisywane. Proszę oddać ekran koordynatorowi.</translation>
    </message>
    <message>
        <source>%1 (skipped)</source>
        <translation>%1 (pominięto)</translation>
    </message>
    <message>
        <source>statements to agree to: %1</source>
        <translation>oświadczenia do zaznaczenia: %1</translation>
    </message>
    <message>
        <source>Choose the language first: another language clears the ticks and the signature.</source>
        <translation>Najpierw wybierz język: zmiana języka usuwa zaznaczenia i podpis.</translation>
    </message>
    <message>
        <source>Leave the consent unfinished?</source>
        <translation>Opuścić niedokończoną zgodę?</translation>
    </message>
    <message>
        <source>The ticks and the signature are not kept.</source>
        <translation>Zaznaczenia i podpis nie zostaną zachowane.</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Wyjdź</translation>
    </message>
    <message>
        <source>Stay here</source>
        <translation>Zostań tutaj</translation>
    </message>
    <message>
        <source>Read the consent in another language?</source>
        <translation>Czytać zgodę w innym języku?</translation>
    </message>
    <message>
        <source>Consent is given in the language that it was read in: the ticks and the signature are cleared.</source>
        <translation>Zgodę wyraża się w języku, w którym ją przeczytano: zaznaczenia i podpis zostaną usunięte.</translation>
    </message>
    <message>
        <source>Change the language</source>
        <translation>Zmień język</translation>
    </message>
    <message>
        <source>the signature, or the mark that it was signed on paper</source>
        <translation>podpis albo zaznaczenie, że podpisano na papierze</translation>
    </message>
    <message>
        <source>Nothing is missing.</source>
        <translation>Niczego nie brakuje.</translation>
    </message>
    <message>
        <source>To consent there is still missing: %1.</source>
        <translation>Do zgody brakuje jeszcze: %1.</translation>
    </message>
</context>
<context>
    <name>TaskPage</name>
    <message>
        <source>Change keys and buttons</source>
        <translation>Zmień klawisze i przyciski</translation>
    </message>
    <message>
        <source>the beginning</source>
        <translation>początek</translation>
    </message>
    <message>
        <source>Begin at</source>
        <translation>Początek próby</translation>
    </message>
    <message>
        <source>The scripted expert does what comes before; the first time this takes a while. An attempt that begins here has no score and counts for nothing.</source>
        <translation>To, co przedtem, wykona symulowany ekspert; za pierwszym razem chwilę to trwa. Próba rozpoczęta od tego miejsca nie ma wyniku i do niczego się nie liczy.</translation>
    </message>
    <message>
        <source>Placode is still working. The attempt begins when that is done, so that the computer is free for it.</source>
        <translation>Placode jeszcze pracuje. Próba zacznie się, gdy skończy, żeby komputer był dla niej wolny.</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Zadanie</translation>
    </message>
    <message>
        <source>The task as a scripted expert does it</source>
        <translation>Zadanie w wykonaniu symulowanego eksperta</translation>
    </message>
    <message>
        <source>Step by step</source>
        <translation>Krok po kroku</translation>
    </message>
    <message>
        <source>What is scored</source>
        <translation>Co jest oceniane</translation>
    </message>
    <message>
        <source>You start with %1 points and pass with %2.</source>
        <translation>Zaczynasz z %1 punktami; zaliczenie od %2.</translation>
    </message>
    <message>
        <source>critical error</source>
        <translation>błąd krytyczny</translation>
    </message>
    <message>
        <source>up to −%1</source>
        <translation>do −%1</translation>
    </message>
    <message>
        <source>%1: at least %2</source>
        <translation>%1: co najmniej %2</translation>
    </message>
    <message>
        <source>%1: less than %2 fails the attempt</source>
        <translation>%1: mniej niż %2 oznacza niezaliczenie próby</translation>
    </message>
    <message>
        <source>%1: any fails the attempt</source>
        <translation>%1: choćby jedno oznacza niezaliczenie próby</translation>
    </message>
    <message>
        <source>%1: more than %2 fails the attempt</source>
        <translation>%1: więcej niż %2 oznacza niezaliczenie próby</translation>
    </message>
    <message>
        <source>%1: none</source>
        <translation>%1: brak</translation>
    </message>
    <message>
        <source>%1: at most %2</source>
        <translation>%1: najwyżej %2</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Urządzenie</translation>
    </message>
    <message>
        <source>Start the attempt</source>
        <translation>Rozpocznij próbę</translation>
    </message>
    <message>
        <source>Controls</source>
        <translation>Sterowanie</translation>
    </message>
    <message>
        <source>A program operates; you watch. Marked as demonstration.</source>
        <translation>Operuje program, Ty patrzysz. Oznaczone jako demonstracja.</translation>
    </message>
    <message>
        <source>Nothing to hold. Escape in the window opens the menu.</source>
        <translation>Nic nie trzeba trzymać. Escape w oknie otwiera menu.</translation>
    </message>
    <message>
        <source>Starting the attempt</source>
        <translation>Rozpoczynanie próby</translation>
    </message>
    <message>
        <source>F1 in the window shows them again, Escape pauses.</source>
        <translation>F1 w oknie pokazuje je ponownie, Escape wstrzymuje.</translation>
    </message>
    <message>
        <source>Exam</source>
        <translation>Egzamin</translation>
    </message>
    <message>
        <source>Attempts left: %1</source>
        <translation>Pozostało prób: %1</translation>
    </message>
    <message>
        <source>Proctor: log-in name</source>
        <translation>Nadzór: login</translation>
    </message>
    <message>
        <source>Proctor: password</source>
        <translation>Nadzór: hasło</translation>
    </message>
    <message>
        <source>An educator or administrator who is present confirms that it may begin.</source>
        <translation>Obecny instruktor lub administrator potwierdza rozpoczęcie.</translation>
    </message>
    <message>
        <source>The exam begins when a proctor has typed log-in name and password.</source>
        <translation>Egzamin zaczyna się, gdy osoba nadzorująca wpisze login i hasło.</translation>
    </message>
    <message>
        <source>Too many wrong passwords. Try again in %1 s.</source>
        <translation>Zbyt wiele błędnych haseł. Spróbuj ponownie za %1 s.</translation>
    </message>
    <message>
        <source>The proctor's log-in name or password is wrong.</source>
        <translation>Login lub hasło osoby nadzorującej jest błędne.</translation>
    </message>
    <message>
        <source>Nobody can be their own proctor; ask somebody who is present.</source>
        <translation>Nikt nie nadzoruje sam siebie; poproś kogoś obecnego.</translation>
    </message>
    <message>
        <source>%1 is neither educator nor administrator and cannot be the proctor.</source>
        <translation>%1 nie jest instruktorem ani administratorem i nie może nadzorować.</translation>
    </message>
    <message>
        <source>What you do earns up to %1 points, harm takes points off. You pass with %2.</source>
        <translation>Za wykonanie można zdobyć do %1 punktów, szkody odejmują punkty. Zaliczenie od %2.</translation>
    </message>
    <message>
        <source>up to +%1</source>
        <translation>do +%1</translation>
    </message>
    <message>
        <source>%1: %2 earn all these points, less in proportion</source>
        <translation>%1: %2 daje wszystkie te punkty, mniej – proporcjonalnie</translation>
    </message>
    <message>
        <source>Time limit %1.</source>
        <translation>Limit czasu %1.</translation>
    </message>
    <message>
        <source>No time limit.</source>
        <translation>Bez limitu czasu.</translation>
    </message>
    <message>
        <source>A window with the fetoscope&apos;s view opens.</source>
        <translation>Otworzy się okno z widokiem z fetoskopu.</translation>
    </message>
    <message>
        <source>An attempt at this exam was not finished and not saved. Save it first: it uses up this attempt.</source>
        <translation>Jedna próba tego egzaminu nie została zakończona ani zapisana. Najpierw ją zapisz: zużywa tę próbę.</translation>
    </message>
    <message>
        <source>F5 in the window shows the planned line.</source>
        <translation>F5 w oknie pokazuje planowaną linię.</translation>
    </message>
    <message>
        <source>Escape in the window pauses.</source>
        <translation>Escape w oknie wstrzymuje próbę.</translation>
    </message>
    <message>
        <source>An educator has set this pass mark; the task's own is %1 points. The benchmark of a course is the course's own.</source>
        <translation>Ten próg zaliczenia ustalił instruktor; własny próg zadania to %1 pkt. Kurs ma swój własny próg.</translation>
    </message>
    <message>
        <source>This exam asks for %1 points.</source>
        <translation>Ten egzamin wymaga %1 pkt.</translation>
    </message>
</context>
<context>
    <name>Theme</name>
    <message>
        <source>Sparing the placode</source>
        <translation>Oszczędzanie płytki</translation>
    </message>
    <message>
        <source>The incision</source>
        <translation>Nacięcie</translation>
    </message>
    <message>
        <source>Freeing and taking out</source>
        <translation>Uwolnienie i wyjęcie</translation>
    </message>
    <message>
        <source>Gentle with tissue</source>
        <translation>Delikatność wobec tkanek</translation>
    </message>
    <message>
        <source>Use of energy</source>
        <translation>Użycie energii</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Czas</translation>
    </message>
    <message>
        <source>Precision and view</source>
        <translation>Precyzja i pole widzenia</translation>
    </message>
    <message>
        <source>Steps of the task</source>
        <translation>Kroki zadania</translation>
    </message>
</context>
<context>
    <name>TodayPage</name>
    <message>
        <source>Newest attempts of trainees</source>
        <translation>Najnowsze próby uczestników szkolenia</translation>
    </message>
    <message>
        <source>All attempts</source>
        <translation>Wszystkie próby</translation>
    </message>
    <message>
        <source>Enter or double click opens the result.</source>
        <translation>Enter lub dwukrotne kliknięcie otwiera wynik.</translation>
    </message>
    <message>
        <source>Good to see you, %1.</source>
        <translation>Dzień dobry, %1.</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Dzisiaj</translation>
    </message>
    <message>
        <source>Next task</source>
        <translation>Następne zadanie</translation>
    </message>
    <message>
        <source>Course completed</source>
        <translation>Kurs ukończony</translation>
    </message>
    <message>
        <source>Every stage is mastered.</source>
        <translation>Wszystkie etapy są zaliczone.</translation>
    </message>
    <message>
        <source>Repeat any task from the course to keep the skill.</source>
        <translation>Powtarzaj dowolne zadanie kursu, aby utrzymać umiejętność.</translation>
    </message>
    <message>
        <source>Open the course</source>
        <translation>Otwórz kurs</translation>
    </message>
    <message>
        <source>Open the task</source>
        <translation>Otwórz zadanie</translation>
    </message>
    <message>
        <source>Last score</source>
        <translation>Ostatni wynik</translation>
    </message>
    <message>
        <source>No attempt yet. Your first one shows up here.</source>
        <translation>Nie ma jeszcze prób. Pierwsza pojawi się tutaj.</translation>
    </message>
    <message>
        <source>Why this score</source>
        <translation>Skąd ten wynik</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>nothing is open</source>
        <translation>nic nie jest otwarte</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>stages mastered: %1</source>
        <translation>zaliczone etapy: %1</translation>
    </message>
    <message>
        <source>Scores of %1</source>
        <translation>Wyniki: %1</translation>
    </message>
    <message>
        <source>The same numbers stand in the history table.</source>
        <translation>Te same liczby są w tabeli historii.</translation>
    </message>
    <message>
        <source>Towards mastery</source>
        <translation>Droga do zaliczenia</translation>
    </message>
    <message>
        <source>attempts with at least %1 points, on the next task</source>
        <translation>próby z co najmniej %1 pkt w następnym zadaniu</translation>
    </message>
    <message>
        <source>attempts in a row with at least %1 points, on the next task</source>
        <translation>prób z rzędu z co najmniej %1 pkt w następnym zadaniu</translation>
    </message>
    <message>
        <source>Why it does not count</source>
        <translation>Dlaczego się nie liczy</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Przeczytaj</translation>
    </message>
    <message numerus="yes">
        <source>%n new remark(s) from your educator</source>
        <translation>
            <numerusform>%n nowa uwaga od osoby prowadzącej</numerusform>
            <numerusform>%n nowe uwagi od osoby prowadzącej</numerusform>
            <numerusform>%n nowych uwag od osoby prowadzącej</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>WatchPage</name>
    <message>
        <source>Reading the recording …</source>
        <translation>Odczyt nagrania …</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Obejrzyj</translation>
    </message>
    <message>
        <source>Back to the result</source>
        <translation>Wróć do wyniku</translation>
    </message>
    <message>
        <source>Moment of the recording</source>
        <translation>Chwila nagrania</translation>
    </message>
    <message>
        <source>Simulating to the moment</source>
        <translation>Symulacja do wybranej chwili</translation>
    </message>
    <message>
        <source>5 s back</source>
        <translation>5 s wstecz</translation>
    </message>
    <message>
        <source>5 s on</source>
        <translation>5 s dalej</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>As operated</source>
        <translation>Jak podczas próby</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Z góry</translation>
    </message>
    <message>
        <source>From the left</source>
        <translation>Z lewej</translation>
    </message>
    <message>
        <source>From the feet</source>
        <translation>Od strony stóp</translation>
    </message>
    <message>
        <source>Near the tip</source>
        <translation>Blisko końcówki</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Prędkość</translation>
    </message>
    <message>
        <source>Speed %1×</source>
        <translation>Prędkość %1×</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Zamknij okno</translation>
    </message>
    <message>
        <source>Reading the recording</source>
        <translation>Odczyt nagrania</translation>
    </message>
    <message>
        <source>The recording cannot be shown.</source>
        <translation>Nie można pokazać nagrania.</translation>
    </message>
    <message>
        <source>Reading the remarks</source>
        <translation>Odczyt uwag</translation>
    </message>
    <message>
        <source>Click the time line to go there</source>
        <translation>Kliknij oś czasu, aby tam przejść</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Czas</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Co</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Gdzie</translation>
    </message>
    <message>
        <source>Entries of the damage ledger</source>
        <translation>Wpisy rejestru uszkodzeń</translation>
    </message>
    <message>
        <source>critical</source>
        <translation>krytyczne</translation>
    </message>
    <message>
        <source>Starting the replay</source>
        <translation>Rozpoczynanie odtwarzania</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Dalej</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pauza</translation>
    </message>
    <message>
        <source>Simulating to %1; going back means beginning again.</source>
        <translation>Symulacja do %1; cofnięcie oznacza symulację od początku.</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pauza</translation>
    </message>
    <message>
        <source>Playing</source>
        <translation>Odtwarzanie</translation>
    </message>
    <message>
        <source>Playing at %1×: this computer cannot do %2×.</source>
        <translation>Odtwarzanie %1×: ten komputer nie zdoła %2×.</translation>
    </message>
    <message>
        <source>Back to the ratings</source>
        <translation>Wróć do ocen</translation>
    </message>
    <message>
        <source>This attempt was kept without a recording, so it cannot be watched. Its result is complete.</source>
        <translation>Ta próba została zapisana bez nagrania, więc nie można jej obejrzeć. Jej wynik jest kompletny.</translation>
    </message>
    <message>
        <source>Keys in its window: Space or Esc pauses and goes on, ← and → jump 5 s, ↑ and ↓ change the speed, V the camera, Q closes it.</source>
        <translation>Klawisze w tamtym oknie: spacja lub Esc zatrzymuje i wznawia, ← i → przeskakują o 5 s, ↑ i ↓ zmieniają prędkość, V kamerę, Q zamyka okno.</translation>
    </message>
    <message>
        <source>The attempt is simulated again exactly, in a window beside this one.</source>
        <translation>Próba jest symulowana jeszcze raz, dokładnie tak samo, w oknie obok.</translation>
    </message>
</context>
<context>
    <name>placode::ui::AppContext</name>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Połącz</translation>
    </message>
    <message>
        <source>Password of the server</source>
        <translation>Hasło do serwera</translation>
    </message>
    <message>
        <source>Password for %1</source>
        <translation>Hasło do %1</translation>
    </message>
    <message>
        <source>Restoring the backup</source>
        <translation>Przywracanie kopii</translation>
    </message>
    <message>
        <source>Bringing the store up to date</source>
        <translation>Dostosowywanie bazy do nowej wersji</translation>
    </message>
    <message>
        <source>Your account was closed. An administrator can open it again.</source>
        <translation>Twoje konto zostało wyłączone. Administrator może je włączyć.</translation>
    </message>
    <message>
        <source>Your roles were changed. Sign in again to go on with them.</source>
        <translation>Zmieniono Twoje role. Zaloguj się ponownie, aby pracować z nowymi.</translation>
    </message>
    <message>
        <source>Opening the store</source>
        <translation>Otwieranie bazy</translation>
    </message>
    <message>
        <source>This</source>
        <translation>To</translation>
    </message>
</context>
<context>
    <name>placode::ui::Banner</name>
    <message>
        <source>Close this message</source>
        <translation>Zamknij ten komunikat</translation>
    </message>
    <message>
        <source>Close this message (Esc)</source>
        <translation>Zamknij tę wiadomość (Esc)</translation>
    </message>
    <message>
        <source>Show folder</source>
        <translation>Pokaż folder</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Otwórz</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>Otwórz folder</translation>
    </message>
</context>
<context>
    <name>placode::ui::MainWindow</name>
    <message>
        <source>The server is away. The attempt is kept on this computer.</source>
        <translation>Nie ma połączenia z serwerem. Próba zostaje na tym komputerze.</translation>
    </message>
    <message>
        <source>It is saved by itself when the server is back.</source>
        <translation>Zapisze się sama, gdy serwer wróci.</translation>
    </message>
    <message>
        <source>The server is still away. Placode goes on trying by itself.</source>
        <translation>Nadal nie ma połączenia z serwerem. Placode próbuje dalej.</translation>
    </message>
    <message>
        <source>Waiting: %1</source>
        <translation>Czeka: %1</translation>
    </message>
    <message>
        <source>Your attempts that are kept on this computer until the server is back. Shows them, and tries again now.</source>
        <translation>Twoje próby, które zostają na tym komputerze, aż serwer wróci. Pokazuje je i próbuje od razu.</translation>
    </message>
    <message>
        <source>An attempt that was kept on this computer is saved now.</source>
        <translation>Próba, która czekała na tym komputerze, jest już zapisana.</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Szkolenie</translation>
    </message>
    <message>
        <source>Teaching</source>
        <translation>Nauczanie</translation>
    </message>
    <message>
        <source>Research</source>
        <translation>Badania</translation>
    </message>
    <message>
        <source>This centre</source>
        <translation>Ośrodek</translation>
    </message>
    <message>
        <source>Writing the audit</source>
        <translation>Zapis w dzienniku</translation>
    </message>
    <message>
        <source>The store is not where it was</source>
        <translation>Bazy nie ma tam, gdzie była</translation>
    </message>
    <message>
        <source>Accounts and attempts were kept in a file that is gone or empty now. Perhaps a disk is not connected, or somebody moved the file. Nothing was changed.</source>
        <translation>Konta i próby były przechowywane w pliku, którego już nie ma albo który jest pusty. Być może dysk nie jest podłączony albo ktoś przeniósł plik. Niczego nie zmieniono.</translation>
    </message>
    <message>
        <source>Placode store (*.db)</source>
        <translation>Baza Placode (*.db)</translation>
    </message>
    <message>
        <source>Show where it is now</source>
        <translation>Wskaż, gdzie jest teraz</translation>
    </message>
    <message>
        <source>Where the store is now</source>
        <translation>Gdzie jest teraz baza</translation>
    </message>
    <message>
        <source>Restore a backup</source>
        <translation>Przywróć kopię</translation>
    </message>
    <message>
        <source>Begin anew, without any data</source>
        <translation>Zacznij od nowa, bez żadnych danych</translation>
    </message>
    <message>
        <source>Begin with an empty store?</source>
        <translation>Zacząć z pustą bazą?</translation>
    </message>
    <message>
        <source>Whoever creates the first account becomes administrator. The old data does not come back by this.</source>
        <translation>Kto utworzy pierwsze konto, zostanie administratorem. Dawne dane w ten sposób nie wrócą.</translation>
    </message>
    <message>
        <source>Begin anew</source>
        <translation>Zacznij od nowa</translation>
    </message>
    <message>
        <source>The store is being read from beginning to end.</source>
        <translation>Baza jest czytana od początku do końca.</translation>
    </message>
    <message>
        <source>A copy of it is being made.</source>
        <translation>Powstaje jej kopia.</translation>
    </message>
    <message>
        <source>Its tables are being changed.</source>
        <translation>Jej tabele są zmieniane.</translation>
    </message>
    <message>
        <source>What it holds is being sealed.</source>
        <translation>To, co zawiera, jest pieczętowane.</translation>
    </message>
    <message>
        <source>The store is being brought up to date</source>
        <translation>Baza jest dostosowywana do nowej wersji</translation>
    </message>
    <message>
        <source>An older version of Placode made it. With many attempts this takes minutes. Do not switch the computer off; Placode goes on by itself.</source>
        <translation>Utworzyła ją starsza wersja Placode. Przy wielu próbach trwa to kilka minut. Nie wyłączaj komputera; Placode sam ruszy dalej.</translation>
    </message>
    <message>
        <source>The store could not be brought up to date</source>
        <translation>Nie udało się dostosować bazy do nowej wersji</translation>
    </message>
    <message>
        <source>No data is lost.</source>
        <translation>Żadne dane nie zginęły.</translation>
    </message>
    <message>
        <source>No data is lost. A copy of the store as it was before is kept: whoever helps finds its place in the details.</source>
        <translation>Żadne dane nie zginęły. Kopia bazy sprzed zmiany została zachowana: gdzie leży, podają szczegóły, dla tego, kto pomaga.</translation>
    </message>
    <message>
        <source>It used up this attempt of the exam. An educator can grant another one.</source>
        <translation>To zużyło tę próbę egzaminu. Osoba prowadząca może przyznać następną.</translation>
    </message>
    <message>
        <source>The attempt was left before it began; nothing was kept.</source>
        <translation>Próba została opuszczona, zanim się zaczęła; nic nie zapisano.</translation>
    </message>
    <message>
        <source>Reading the accounts</source>
        <translation>Odczyt kont</translation>
    </message>
    <message>
        <source>Placode cannot open its store.</source>
        <translation>Placode nie może otworzyć swojej bazy.</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Strony</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Dzisiaj</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historia</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Próby</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Badania</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Osoby</translation>
    </message>
    <message>
        <source>Health</source>
        <translation>Stan</translation>
    </message>
    <message>
        <source>Audit</source>
        <translation>Dziennik</translation>
    </message>
    <message>
        <source>Attempt is running</source>
        <translation>Próba trwa</translation>
    </message>
    <message>
        <source>Light theme</source>
        <translation>Jasny motyw</translation>
    </message>
    <message>
        <source>Dark theme</source>
        <translation>Ciemny motyw</translation>
    </message>
    <message>
        <source>Account of %1</source>
        <translation>Konto: %1</translation>
    </message>
    <message>
        <source>My account</source>
        <translation>Moje konto</translation>
    </message>
    <message>
        <source>Unfinished attempts</source>
        <translation>Niedokończone próby</translation>
    </message>
    <message>
        <source>Switch user</source>
        <translation>Zmień użytkownika</translation>
    </message>
    <message>
        <source>Sign out</source>
        <translation>Wyloguj się</translation>
    </message>
    <message>
        <source>Opening the page</source>
        <translation>Otwieranie strony</translation>
    </message>
    <message>
        <source>This page cannot be shown.</source>
        <translation>Nie można pokazać tej strony.</translation>
    </message>
    <message>
        <source>The backup is in place. Whoever was erased since it was made is back, and so are the data of participants who withdrew since: look at your list of requests, and erase them again.</source>
        <translation>Kopia jest na miejscu. Osoby usunięte po jej wykonaniu wróciły, a z nimi dane uczestników, którzy się potem wycofali: sprawdź listę wniosków i usuń je ponownie.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Spróbuj ponownie</translation>
    </message>
    <message>
        <source>Scoring and saving the attempt</source>
        <translation>Ocena i zapis próby</translation>
    </message>
    <message>
        <source>Your attempt was saved.</source>
        <translation>Twoja próba została zapisana.</translation>
    </message>
    <message>
        <source>Open the result</source>
        <translation>Otwórz wynik</translation>
    </message>
    <message>
        <source>Looking for unfinished attempts</source>
        <translation>Szukanie niedokończonych prób</translation>
    </message>
    <message>
        <source>An attempt of %1 was not finished or not saved (%2).</source>
        <translation>Próba z %1 nie została dokończona lub zapisana (%2).</translation>
    </message>
    <message>
        <source>Attempts that were not finished or not saved: %1.</source>
        <translation>Próby niedokończone lub niezapisane: %1.</translation>
    </message>
    <message>
        <source>%1 was erased; the certificate can be saved.</source>
        <translation>Usunięto: %1; można zapisać zaświadczenie.</translation>
    </message>
    <message>
        <source>Copies that may still hold the person: %1.</source>
        <translation>Kopie, które mogą jeszcze zawierać dane tej osoby: %1.</translation>
    </message>
    <message>
        <source>Look at it</source>
        <translation>Zobacz</translation>
    </message>
    <message>
        <source>Stay here</source>
        <translation>Zostań tutaj</translation>
    </message>
    <message>
        <source>Close Placode when its work is done?</source>
        <translation>Zamknąć Placode po zakończeniu pracy?</translation>
    </message>
    <message>
        <source>%1: this is still running. Placode closes by itself when it is done; if it fails, Placode stays open.</source>
        <translation>%1: to jeszcze trwa. Program zamknie się, gdy skończy; jeśli się nie uda, zostanie otwarty.</translation>
    </message>
    <message>
        <source>Close when done</source>
        <translation>Zamknij po zakończeniu</translation>
    </message>
    <message>
        <source>Close Placode while an attempt is running?</source>
        <translation>Zamknąć Placode podczas próby?</translation>
    </message>
    <message>
        <source>The attempt ends. Its recording is kept and offered at the next start.</source>
        <translation>Próba się skończy. Nagranie zostanie i pojawi się przy następnym uruchomieniu.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>Go on with the study</source>
        <translation>Dalej w badaniu</translation>
    </message>
    <message>
        <source>Cohort</source>
        <translation>Postępy</translation>
    </message>
    <message>
        <source>Ratings</source>
        <translation>Oceny</translation>
    </message>
    <message>
        <source>Standards</source>
        <translation>Progi</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Szukaj</translation>
    </message>
    <message>
        <source>Search pages, tasks, people, attempts and the manual (Ctrl+K)</source>
        <translation>Szukaj stron, zadań, osób, prób i w podręczniku (Ctrl+K)</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Urządzenia</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Dane</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Wyniki</translation>
    </message>
    <message>
        <source>Protocols</source>
        <translation>Protokoły</translation>
    </message>
    <message>
        <source>Courses</source>
        <translation>Wszystkie kursy</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Grupy</translation>
    </message>
    <message>
        <source>Norms</source>
        <translation>Normy</translation>
    </message>
    <message>
        <source>Locked after a time without a touch. Come back where you were.</source>
        <translation>Zablokowano po czasie bezczynności. Wrócisz tam, gdzie praca została przerwana.</translation>
    </message>
    <message>
        <source>What was recorded is kept. Please call the coordinator.</source>
        <translation>Nagranie jest zachowane. Proszę zawołać koordynatora.</translation>
    </message>
    <message>
        <source>Signs you out, so that the next person can sign in</source>
        <translation>Wylogowuje, aby mogła się zalogować następna osoba</translation>
    </message>
    <message>
        <source>Sign out while your attempt is running?</source>
        <translation>Wylogować się w czasie trwającej próby?</translation>
    </message>
    <message>
        <source>The attempt goes on in its window and is saved under your name. You do not see its result until you sign in again.</source>
        <translation>Próba trwa dalej w swoim oknie i zostanie zapisana pod Twoim nazwiskiem. Wynik zobaczysz dopiero po ponownym zalogowaniu.</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Zostań</translation>
    </message>
    <message>
        <source>What was recorded is saved and uses up this attempt of the exam. An educator can grant another one.</source>
        <translation>To, co nagrano, zostaje zapisane i zużywa tę próbę egzaminu. Osoba prowadząca może przyznać następną.</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Pomoc</translation>
    </message>
    <message>
        <source>The chapter of the manual on this page (F1)</source>
        <translation>Rozdział podręcznika o tej stronie (F1)</translation>
    </message>
    <message>
        <source>Use this computer&apos;s own store</source>
        <translation>Użyj bazy tego komputera</translation>
    </message>
</context>
<context>
    <name>placode::ui::SearchBox</name>
    <message>
        <source>Search</source>
        <translation>Szukaj</translation>
    </message>
    <message>
        <source>Page, task, person, attempt, manual</source>
        <translation>Strona, zadanie, osoba, próba, podręcznik</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Znalezione</translation>
    </message>
    <message>
        <source>task</source>
        <translation>zadanie</translation>
    </message>
    <message>
        <source>Reading the people</source>
        <translation>Czytanie osób</translation>
    </message>
    <message>
        <source>Reading the attempts</source>
        <translation>Czytanie prób</translation>
    </message>
    <message>
        <source>attempt %1</source>
        <translation>próba %1</translation>
    </message>
    <message>
        <source>Reading the attempts …</source>
        <translation>Czytanie prób …</translation>
    </message>
    <message>
        <source>Nothing found. Try fewer letters, a name or a date.</source>
        <translation>Nic nie znaleziono. Spróbuj mniej liter, nazwiska lub daty.</translation>
    </message>
    <message>
        <source>Arrow keys choose, Enter opens, Escape closes.</source>
        <translation>Strzałki wybierają, Enter otwiera, Escape zamyka.</translation>
    </message>
    <message>
        <source>manual</source>
        <translation>podręcznik</translation>
    </message>
</context>
<context>
    <name>CalibrationGuide</name>
    <message>
        <source>1. Calibrate the arm in the vendor's own program (Touch Diagnostic).</source>
        <translation>1. Skalibruj ramię w programie producenta (Touch Diagnostic).</translation>
    </message>
    <message>
        <source>2. Put the stylus into the inkwell until its light stops blinking.</source>
        <translation>2. Wstaw rysik do kałamarza i poczekaj, aż lampka przestanie migać.</translation>
    </message>
    <message>
        <source>3. Take it out: from now on the arm is ready.</source>
        <translation>3. Wyjmij go: od tej chwili ramię jest gotowe.</translation>
    </message>
    <message>
        <source>1. Start the Haply hub and its Inverse service.</source>
        <translation>1. Uruchom Haply Hub i jego usługę Inverse.</translation>
    </message>
    <message>
        <source>2. Hold the cursor in the calibration notch and press its button until the light is steady.</source>
        <translation>2. Trzymaj kursor w gnieździe kalibracji i naciskaj jego przycisk, aż lampka zaświeci stale.</translation>
    </message>
    <message>
        <source>3. Wake the grip by a press of its button.</source>
        <translation>3. Obudź uchwyt naciśnięciem jego przycisku.</translation>
    </message>
    <message>
        <source>1. Calibrate in the vendor's program HapticInit, or move every axis to its ends once.</source>
        <translation>1. Skalibruj w programie producenta HapticInit albo przesuń każdą oś raz do obu końców.</translation>
    </message>
    <message>
        <source>2. Press the force button on the base, if it has one.</source>
        <translation>2. Naciśnij przycisk siły na podstawie, jeśli urządzenie go ma.</translation>
    </message>
    <message>
        <source>1. Put the instrument into the port device before it is switched on.</source>
        <translation>1. Włóż narzędzie do urządzenia portowego, zanim zostanie ono włączone.</translation>
    </message>
    <message>
        <source>2. Turn and move it once through its whole way.</source>
        <translation>2. Obróć je i przesuń raz przez cały zakres.</translation>
    </message>
    <message>
        <source>3. With the tip at the port, the depth must read 0; else set avatar.depth_zero_m.</source>
        <translation>3. Gdy końcówka jest przy porcie, głębokość musi wynosić 0; jeśli nie, ustaw avatar.depth_zero_m.</translation>
    </message>
    <message>
        <source>Let go of the cap: every signal must be 0. The cap gives no force.</source>
        <translation>Puść gałkę: każdy sygnał musi wynosić 0. Gałka nie daje siły.</translation>
    </message>
</context>
<context>
    <name>DevicesPage</name>
    <message>
        <source>Devices of this computer</source>
        <translation>Urządzenia tego komputera</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Urządzenia</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Co znaleziono</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Szukaj ponownie</translation>
    </message>
    <message>
        <source>Looking for devices; this may take some seconds…</source>
        <translation>Szukanie urządzeń; może potrwać kilka sekund…</translation>
    </message>
    <message>
        <source>Looking for devices</source>
        <translation>Szukanie urządzeń</translation>
    </message>
    <message>
        <source>found</source>
        <translation>jest</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nie ma</translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>Wypróbuj</translation>
    </message>
    <message>
        <source>Reading the station file</source>
        <translation>Odczyt pliku stanowiska</translation>
    </message>
    <message>
        <source>Saving the station file</source>
        <translation>Zapis pliku stanowiska</translation>
    </message>
    <message>
        <source>Settings of this computer</source>
        <translation>Ustawienia tego komputera</translation>
    </message>
    <message>
        <source>Force test passed with %1 N: %2, %3.</source>
        <translation>Test siły zdany przy %1 N: %2, %3.</translation>
    </message>
    <message>
        <source>No force test was passed on this computer yet.</source>
        <translation>Na tym komputerze nie zdano jeszcze testu siły.</translation>
    </message>
    <message>
        <source>Save the settings</source>
        <translation>Zapisz ustawienia</translation>
    </message>
    <message>
        <source> (%1 to %2)</source>
        <translation> (%1 do %2)</translation>
    </message>
    <message>
        <source>Saved for this computer.</source>
        <translation>Zapisano dla tego komputera.</translation>
    </message>
    <message>
        <source>Foot pedals</source>
        <translation>Pedały nożne</translation>
    </message>
    <message>
        <source>Choose the pedals, press each and say which one it is: yellow cuts, blue coagulates. Pedals that a device brings itself need nothing here.</source>
        <translation>Wybierz pedały, naciśnij każdy i powiedz, który to: żółty tnie, niebieski koaguluje. Pedały, które należą do urządzenia, niczego tu nie potrzebują.</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Obserwuj</translation>
    </message>
    <message>
        <source>This is the yellow one</source>
        <translation>To jest żółty</translation>
    </message>
    <message>
        <source>This is the blue one</source>
        <translation>To jest niebieski</translation>
    </message>
    <message>
        <source>Press a pedal…</source>
        <translation>Naciśnij pedał…</translation>
    </message>
    <message>
        <source>Watching the pedals</source>
        <translation>Obserwacja pedałów</translation>
    </message>
    <message>
        <source>The pedals are unplugged.</source>
        <translation>Pedały są odłączone.</translation>
    </message>
    <message>
        <source>Key %1</source>
        <translation>Klawisz %1</translation>
    </message>
    <message>
        <source>, set as the yellow pedal</source>
        <translation>, ustawiony jako żółty pedał</translation>
    </message>
    <message>
        <source>, set as the blue pedal</source>
        <translation>, ustawiony jako niebieski pedał</translation>
    </message>
    <message>
        <source>%1 (pressed)</source>
        <translation>%1 (naciśnięty)</translation>
    </message>
    <message>
        <source>The pedal was saved for this computer.</source>
        <translation>Pedał zapisano dla tego komputera.</translation>
    </message>
    <message>
        <source>The list of devices could not be read.</source>
        <translation>Nie udało się odczytać listy urządzeń.</translation>
    </message>
    <message>
        <source>No pedals were found.</source>
        <translation>Nie znaleziono pedałów.</translation>
    </message>
    <message>
        <source>They hold for this computer, whoever is signed in. Change one only when a device does not do what the hand does.</source>
        <translation>Obowiązują na tym komputerze, niezależnie od tego, kto jest zalogowany. Zmieniaj je tylko wtedy, gdy urządzenie nie robi tego, co ręka.</translation>
    </message>
    <message>
        <source>Which pedals</source>
        <translation>Które pedały</translation>
    </message>
    <message>
        <source>What the arm stands for</source>
        <translation>Czym jest ramię</translation>
    </message>
    <message>
        <source>Scale of the motion</source>
        <translation>Skala ruchu</translation>
    </message>
    <message>
        <source>Hand of a single arm</source>
        <translation>Ręka pojedynczego ramienia</translation>
    </message>
    <message>
        <source>Stiffness at most</source>
        <translation>Sztywność najwyżej</translation>
    </message>
    <message>
        <source>Damping at most</source>
        <translation>Tłumienie najwyżej</translation>
    </message>
    <message>
        <source>Force at most</source>
        <translation>Siła najwyżej</translation>
    </message>
    <message>
        <source>Program library of the vendor</source>
        <translation>Biblioteka producenta</translation>
    </message>
    <message>
        <source>Right arm</source>
        <translation>Prawe ramię</translation>
    </message>
    <message>
        <source>Left arm</source>
        <translation>Lewe ramię</translation>
    </message>
    <message>
        <source>Computer of the vendor&apos;s service</source>
        <translation>Komputer z usługą producenta</translation>
    </message>
    <message>
        <source>Its port</source>
        <translation>Jej port</translation>
    </message>
    <message>
        <source>Directions of the arm</source>
        <translation>Kierunki ramienia</translation>
    </message>
    <message>
        <source>Force that the arm can do</source>
        <translation>Siła, którą ramię osiąga</translation>
    </message>
    <message>
        <source>Right port device</source>
        <translation>Urządzenie prawego portu</translation>
    </message>
    <message>
        <source>Left port device</source>
        <translation>Urządzenie lewego portu</translation>
    </message>
    <message>
        <source>Handle and pedal box</source>
        <translation>Moduł uchwytu i pedałów</translation>
    </message>
    <message>
        <source>Directions of the axes</source>
        <translation>Kierunki osi</translation>
    </message>
    <message>
        <source>Depth at the port</source>
        <translation>Głębokość przy porcie</translation>
    </message>
    <message>
        <source>Wait after opening</source>
        <translation>Czekanie po otwarciu</translation>
    </message>
    <message>
        <source>Right and left exchanged</source>
        <translation>Zamiana prawej i lewej</translation>
    </message>
    <message>
        <source>Connection to its service</source>
        <translation>Połączenie z usługą</translation>
    </message>
    <message>
        <source>Speed at full deflection</source>
        <translation>Prędkość przy pełnym wychyleniu</translation>
    </message>
</context>
<context>
    <name>placode::ui::SignalView</name>
    <message>
        <source>right %1 mm, up %2 mm, towards you %3 mm, force %4 N</source>
        <translation>w prawo %1 mm, w górę %2 mm, do siebie %3 mm, siła %4 N</translation>
    </message>
    <message>
        <source>to you</source>
        <translation>do siebie</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>force</source>
        <translation>siła</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
</context>
<context>
    <name>Station</name>
    <message>
        <source>handle: the arm is the handle outside the body (the port inverts); tip: it is the tip</source>
        <translation>handle: ramię jest uchwytem poza ciałem (port odwraca ruch); tip: jest końcówką</translation>
    </message>
    <message>
        <source>motion of the handle per motion of the arm</source>
        <translation>ruch uchwytu na ruch ramienia</translation>
    </message>
    <message>
        <source>right or left: the hand that a single arm stands for</source>
        <translation>right (prawa) lub left (lewa): ręka, którą zastępuje jedyne ramię</translation>
    </message>
    <message>
        <source>stiffness of the virtual coupling [N/m]</source>
        <translation>sztywność wirtualnego sprzęgu [N/m]</translation>
    </message>
    <message>
        <source>its damping [N s/m]</source>
        <translation>jego tłumienie [N s/m]</translation>
    </message>
    <message>
        <source>largest force [N]; 0.5 for the first test of a device</source>
        <translation>największa siła [N]; 0,5 przy pierwszym teście urządzenia</translation>
    </message>
    <message>
        <source>path of libHD.so; empty: as the system finds it</source>
        <translation>ścieżka libHD.so; puste: tak jak znajdzie ją system</translation>
    </message>
    <message>
        <source>name of the right arm in the vendor's setup; empty: try the default device, "Default PHANToM" and "Right Device"</source>
        <translation>nazwa prawego ramienia w programie producenta; puste: urządzenie domyślne, "Default PHANToM" i "Right Device"</translation>
    </message>
    <message>
        <source>name of the left arm; empty: no left arm</source>
        <translation>nazwa lewego ramienia; puste: bez lewego ramienia</translation>
    </message>
    <message>
        <source>address of the Inverse service</source>
        <translation>adres usługi Inverse</translation>
    </message>
    <message>
        <source>its WebSocket port</source>
        <translation>jej port WebSocket</translation>
    </message>
    <message>
        <source>device_id of the right Inverse3; empty: the first, with a left arm the first that is not left-handed</source>
        <translation>device_id prawego Inverse3; puste: pierwsze, a przy lewym ramieniu pierwsze, które nie jest leworęczne</translation>
    </message>
    <message>
        <source>device_id of the left Inverse3; auto: the first that says it is left-handed; empty: no left arm</source>
        <translation>device_id lewego Inverse3; auto: pierwsze, które podaje się za leworęczne; puste: bez lewego ramienia</translation>
    </message>
    <message>
        <source>the device's axes that are our x (right), y (up), z (to the operator)</source>
        <translation>osie urządzenia, które są naszymi x (w prawo), y (w górę), z (do operatora)</translation>
    </message>
    <message>
        <source>its largest force [N]; not confirmed by the vendor</source>
        <translation>jego największa siła [N]; niepotwierdzona przez producenta</translation>
    </message>
    <message>
        <source>serial port of the right port device</source>
        <translation>port szeregowy prawego urządzenia portowego</translation>
    </message>
    <message>
        <source>serial port of the left port device; empty: none</source>
        <translation>port szeregowy lewego urządzenia portowego; puste: brak</translation>
    </message>
    <message>
        <source>serial port of the handle and pedal box; empty: none</source>
        <translation>port szeregowy skrzynki uchwytów i pedałów; puste: brak</translation>
    </message>
    <message>
        <source>signs of rotation, pitch, depth, yaw, each 1 or -1</source>
        <translation>znaki obrotu, pochylenia, głębokości i odchylenia, każdy 1 albo -1</translation>
    </message>
    <message>
        <source>depth that the device reports with the tip at the port [m]</source>
        <translation>głębokość, którą urządzenie podaje, gdy końcówka jest przy porcie [m]</translation>
    </message>
    <message>
        <source>wait after opening the port, its board starts anew [s]</source>
        <translation>czekanie po otwarciu portu, płytka zaczyna od nowa [s]</translation>
    </message>
    <message>
        <source>path of libdhd.so or libdrd.so; empty: as the system finds it</source>
        <translation>ścieżka libdhd.so lub libdrd.so; puste: tak jak znajdzie ją system</translation>
    </message>
    <message>
        <source>1: the device that says left-handed is the right one</source>
        <translation>1: urządzenie, które podaje się za leworęczne, jest prawym</translation>
    </message>
    <message>
        <source>socket of spacenavd; empty: $SPNAV_SOCKET, /run/spnav.sock, /var/run/spnav.sock</source>
        <translation>gniazdo spacenavd; puste: $SPNAV_SOCKET, /run/spnav.sock, /var/run/spnav.sock</translation>
    </message>
    <message>
        <source>speed at full deflection [m/s]</source>
        <translation>prędkość przy pełnym wychyleniu [m/s]</translation>
    </message>
    <message>
        <source>device whose force was tested on this computer by a person</source>
        <translation>urządzenie, którego siłę człowiek wypróbował na tym komputerze</translation>
    </message>
    <message>
        <source>largest force with which that test was passed [N]</source>
        <translation>największa siła, przy której zdano test [N]</translation>
    </message>
    <message>
        <source>when</source>
        <translation>kiedy</translation>
    </message>
    <message>
        <source>foot pedals: /dev/input/by-id/...-event-kbd; empty: none but the keyboard's F13, F14</source>
        <translation>pedały nożne: /dev/input/by-id/...-event-kbd; puste: tylko F13 i F14 klawiatury</translation>
    </message>
    <message>
        <source>code of the yellow pedal (KEY_F13 is 183)</source>
        <translation>kod żółtego pedału (KEY_F13 to 183)</translation>
    </message>
    <message>
        <source>code of the blue pedal (KEY_F14 is 184)</source>
        <translation>kod niebieskiego pedału (KEY_F14 to 184)</translation>
    </message>
</context>
<context>
    <name>TrialCard</name>
    <message>
        <source>No real-time rights: other programs can make the force stutter. An administrator grants them once: %1, then puts the user into the group placode.</source>
        <translation>Brak uprawnień czasu rzeczywistego: inne programy mogą powodować nierówną siłę. Administrator nadaje je raz: %1, a potem dodaje użytkownika do grupy placode.</translation>
    </message>
    <message>
        <source>Last error of the device: %1.</source>
        <translation>Ostatni błąd urządzenia: %1.</translation>
    </message>
    <message>
        <source>Waiting for the device…</source>
        <translation>Czekanie na urządzenie…</translation>
    </message>
    <message>
        <source>Trying: %1</source>
        <translation>Test: %1</translation>
    </message>
    <message>
        <source>End the test</source>
        <translation>Zakończ test</translation>
    </message>
    <message>
        <source>Force test</source>
        <translation>Test siły</translation>
    </message>
    <message>
        <source>Put a floor under the hand</source>
        <translation>Ustaw podłogę pod ręką</translation>
    </message>
    <message>
        <source>It pushed me out softly</source>
        <translation>Wypchnęło mnie łagodnie</translation>
    </message>
    <message>
        <source>First put the floor under the hand: a force that nobody felt is not passed.</source>
        <translation>Najpierw ustaw podłogę pod ręką: siły, której nikt nie poczuł, nie można zaliczyć.</translation>
    </message>
    <message>
        <source>It buzzed or pushed wrongly</source>
        <translation>Brzęczało albo pchało źle</translation>
    </message>
    <message>
        <source>Right and left hand</source>
        <translation>Prawa i lewa ręka</translation>
    </message>
    <message>
        <source>Find the right hand</source>
        <translation>Znajdź prawą rękę</translation>
    </message>
    <message>
        <source>Swap right and left</source>
        <translation>Zamień prawą z lewą</translation>
    </message>
    <message>
        <source>Trying the device</source>
        <translation>Test urządzenia</translation>
    </message>
    <message>
        <source>Now with at most %1 N. Hold the arm in the air, put the floor under it, go down slowly until it carries the hand, then let go: it must come to rest. One hand on the arm, the other at its power switch.</source>
        <translation>Teraz najwyżej %1 N. Trzymaj ramię w powietrzu, ustaw podłogę, opuszczaj je powoli, aż podłoga podeprze rękę, potem puść: musi się uspokoić. Jedna ręka na ramieniu, druga przy wyłączniku.</translation>
    </message>
    <message>
        <source>Signals of %1</source>
        <translation>Sygnały: %1</translation>
    </message>
    <message>
        <source>Left hand: %1</source>
        <translation>Lewa ręka: %1</translation>
    </message>
    <message>
        <source>Right hand: %1</source>
        <translation>Prawa ręka: %1</translation>
    </message>
    <message>
        <source>Loop: %1 µs, 99.9 %: %2 µs, drop-outs %3, faults %4. Force at most %5 N, stiffness %6 N/m.</source>
        <translation>Pętla: %1 µs, 99,9 %: %2 µs, przerwy %3, usterki %4. Siła najwyżej %5 N, sztywność %6 N/m.</translation>
    </message>
    <message>
        <source>Take the floor away</source>
        <translation>Zabierz podłogę</translation>
    </message>
    <message>
        <source>This device gives no force: there is nothing to test.</source>
        <translation>To urządzenie nie daje siły: nie ma czego testować.</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>gotowe</translation>
    </message>
    <message>
        <source>rests: take it out of its inkwell or cradle</source>
        <translation>odłożone: wyjmij je z kałamarza lub podstawki</translation>
    </message>
    <message>
        <source>not calibrated: follow the steps above</source>
        <translation>nieskalibrowane: wykonaj kroki powyżej</translation>
    </message>
    <message>
        <source>lost: is it plugged in and switched on?</source>
        <translation>brak łączności: czy jest podłączone i włączone?</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>usterka</translation>
    </message>
    <message>
        <source>button %1</source>
        <translation>przycisk %1</translation>
    </message>
    <message>
        <source>yellow pedal</source>
        <translation>żółty pedał</translation>
    </message>
    <message>
        <source>blue pedal</source>
        <translation>niebieski pedał</translation>
    </message>
    <message>
        <source>turn %1°</source>
        <translation>obrót %1°</translation>
    </message>
    <message>
        <source>One arm: it stands for the %1 hand.</source>
        <translation>Jedno ramię: to %1 ręka.</translation>
    </message>
    <message>
        <source>right</source>
        <translation>prawa</translation>
    </message>
    <message>
        <source>left</source>
        <translation>lewa</translation>
    </message>
    <message>
        <source>Find out which arm is the right one: press the button below, then move only the arm in your right hand, or press its button.</source>
        <translation>Sprawdź, które ramię jest prawe: naciśnij przycisk poniżej, potem poruszaj tylko ramieniem w prawej ręce albo naciśnij jego przycisk.</translation>
    </message>
    <message>
        <source>Move the arm in your right hand now; let the other rest.</source>
        <translation>Poruszaj teraz ramieniem w prawej ręce; drugie niech spoczywa.</translation>
    </message>
    <message>
        <source>✓ That is the arm that is set as the right one.</source>
        <translation>✓ To ramię jest ustawione jako prawe.</translation>
    </message>
    <message>
        <source>That arm is set as the left one: swap right and left.</source>
        <translation>To ramię jest ustawione jako lewe: zamień prawe z lewym.</translation>
    </message>
    <message>
        <source>Right and left were swapped and saved.</source>
        <translation>Prawe i lewe zamieniono i zapisano.</translation>
    </message>
    <message>
        <source>%1 N passed and saved; now %2 N.</source>
        <translation>%1 N zdane i zapisane; teraz %2 N.</translation>
    </message>
    <message>
        <source>%1 N passed and saved: the test is complete.</source>
        <translation>%1 N zdane i zapisane: test jest zakończony.</translation>
    </message>
    <message>
        <source>The force of this computer is limited to %1 N now. Check the axes and signs of the device before you try again.</source>
        <translation>Siła na tym komputerze jest teraz ograniczona do %1 N. Sprawdź osie i znaki urządzenia, zanim spróbujesz ponownie.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Spróbuj ponownie</translation>
    </message>
    <message>
        <source>The test has ended; no force.</source>
        <translation>Test zakończony; brak siły.</translation>
    </message>
</context>
<context>
    <name>DefinitionFields</name>
    <message>
        <source>Id: letters, digits, _</source>
        <translation>Identyfikator: litery, cyfry, _</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Wersja</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Tytuł</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Opis</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Źródło</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Wizyty</translation>
    </message>
    <message>
        <source>Information, a paragraph a line: English | Polish</source>
        <translation>Informacja, akapit w wierszu: angielski | polski</translation>
    </message>
    <message>
        <source>Statements to agree to, one a line: id | English | Polish</source>
        <translation>Oświadczenia, jedno w wierszu: identyfikator | angielski | polski</translation>
    </message>
    <message>
        <source>Names of the arms, one a line: English | Polish (empty = no arms)</source>
        <translation>Nazwy grup, jedna w wierszu: angielski | polski (puste = bez grup)</translation>
    </message>
    <message>
        <source>Size of a block: a multiple of the number of arms</source>
        <translation>Wielkość bloku: wielokrotność liczby grup</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Rodzaj</translation>
    </message>
    <message>
        <source>Text to read, a paragraph a line: English | Polish</source>
        <translation>Tekst do przeczytania, akapit w wierszu: angielski | polski</translation>
    </message>
    <message>
        <source>Questionnaire: its id</source>
        <translation>Kwestionariusz: identyfikator</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Zadanie</translation>
    </message>
    <message>
        <source>At most [s] (familiarisation)</source>
        <translation>Najwyżej [s] (zapoznanie)</translation>
    </message>
    <message>
        <source>Time limit [s] (procedure; empty = none)</source>
        <translation>Limit czasu [s] (zabieg; puste = bez limitu)</translation>
    </message>
    <message>
        <source>Only for these arms, from 0 (empty = everybody)</source>
        <translation>Tylko dla tych grup, od 0 (puste = wszyscy)</translation>
    </message>
    <message>
        <source>Introduction</source>
        <translation>Wstęp</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>Licencja</translation>
    </message>
    <message>
        <source>Scale scores, one a line: id | mean or sum, then the items | English | Polish</source>
        <translation>Wyniki skal, jeden w wierszu: identyfikator | mean lub sum, potem pytania | angielski | polski</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Pytanie</translation>
    </message>
    <message>
        <source>Scale from</source>
        <translation>Skala od</translation>
    </message>
    <message>
        <source>Scale to</source>
        <translation>Skala do</translation>
    </message>
    <message>
        <source>Word at the low end</source>
        <translation>Słowo na dolnym końcu</translation>
    </message>
    <message>
        <source>Word at the high end</source>
        <translation>Słowo na górnym końcu</translation>
    </message>
    <message>
        <source>Choices, one a line: English | Polish</source>
        <translation>Odpowiedzi, jedna w wierszu: angielski | polski</translation>
    </message>
    <message>
        <source>Least number</source>
        <translation>Najmniejsza liczba</translation>
    </message>
    <message>
        <source>Greatest number</source>
        <translation>Największa liczba</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Jednostka</translation>
    </message>
    <message>
        <source>Shown only if: item = answers</source>
        <translation>Pokazywane tylko, gdy: pytanie = odpowiedzi</translation>
    </message>
    <message>
        <source>An answer is required</source>
        <translation>Odpowiedź jest wymagana</translation>
    </message>
    <message>
        <source>"Does not apply" may be answered</source>
        <translation>Można odpowiedzieć „nie dotyczy”</translation>
    </message>
    <message>
        <source>Turned round in scale scores</source>
        <translation>Odwracane w wynikach skal</translation>
    </message>
    <message>
        <source>Names a person: leaves only with permission</source>
        <translation>Wskazuje osobę: eksport tylko za zgodą</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Zgoda</translation>
    </message>
    <message>
        <source>Questionnaire</source>
        <translation>Kwestionariusz</translation>
    </message>
    <message>
        <source>Briefing: text to read</source>
        <translation>Instruktaż: tekst do przeczytania</translation>
    </message>
    <message>
        <source>Familiarisation: free practice</source>
        <translation>Zapoznanie: swobodne ćwiczenie</translation>
    </message>
    <message>
        <source>Procedure: a recorded task</source>
        <translation>Zabieg: nagrywane zadanie</translation>
    </message>
    <message>
        <source>Likert scale</source>
        <translation>Skala Likerta</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Liczba</translation>
    </message>
    <message>
        <source>One choice</source>
        <translation>Jedna odpowiedź</translation>
    </message>
    <message>
        <source>Several choices</source>
        <translation>Kilka odpowiedzi</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Data</translation>
    </message>
    <message>
        <source>Visual analogue scale</source>
        <translation>Wizualna skala analogowa</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Tekst</translation>
    </message>
    <message>
        <source>none</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>the planned line</source>
        <translation>planowana linia</translation>
    </message>
    <message>
        <source>read-outs</source>
        <translation>wskazania liczbowe</translation>
    </message>
    <message>
        <source>warnings</source>
        <translation>ostrzeżenia</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>głębokość</translation>
    </message>
    <message>
        <source>Why it differs from the version before</source>
        <translation>Czym i dlaczego różni się od poprzedniej wersji</translation>
    </message>
    <message>
        <source>Least duration [s]: a shorter attempt does not count as done</source>
        <translation>Najkrótszy czas [s]: krótsza próba nie zalicza kroku</translation>
    </message>
    <message>
        <source>Device, e.g. mouse (empty = the coordinator chooses once)</source>
        <translation>Urządzenie, np. mouse (puste = koordynator wybiera raz)</translation>
    </message>
    <message>
        <source>What the picture may show</source>
        <translation>Co może pokazywać obraz</translation>
    </message>
    <message>
        <source>as usual</source>
        <translation>jak zwykle</translation>
    </message>
</context>
<context>
    <name>StudyPreview</name>
    <message>
        <source>Signature on the screen or on paper</source>
        <translation>Podpis na ekranie lub na papierze</translation>
    </message>
    <message>
        <source>Preview: what participants go through</source>
        <translation>Podgląd: przez co przechodzą uczestnicy</translation>
    </message>
    <message>
        <source>Visits: %1</source>
        <translation>Wizyty: %1</translation>
    </message>
    <message>
        <source>Only: %1</source>
        <translation>Tylko: %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>najwyżej %1</translation>
    </message>
    <message>
        <source>a date</source>
        <translation>data</translation>
    </message>
    <message>
        <source>free text</source>
        <translation>tekst dowolny</translation>
    </message>
    <message>
        <source>asked only if %1 = %2</source>
        <translation>tylko gdy %1 = %2</translation>
    </message>
    <message>
        <source> or </source>
        <translation> lub </translation>
    </message>
    <message>
        <source>reverse-keyed</source>
        <translation>odwrotnie punktowane</translation>
    </message>
    <message>
        <source>names a person</source>
        <translation>wskazuje osobę</translation>
    </message>
    <message>
        <source>counts for %1</source>
        <translation>liczy się do: %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>co najmniej %1</translation>
    </message>
    <message>
        <source>the coordinator chooses the device</source>
        <translation>urządzenie wybiera koordynator</translation>
    </message>
    <message>
        <source>device: %1</source>
        <translation>urządzenie: %1</translation>
    </message>
    <message>
        <source>Publish a draft?</source>
        <translation>Opublikować wersję roboczą?</translation>
    </message>
    <message>
        <source>This text still calls itself a draft:

&quot;%1&quot;

Participants would read it like this, and a version that is published is never changed. Put in the approved text first: Protocols edits it.</source>
        <translation>Ten tekst wciąż nazywa się wersją roboczą:

„%1”

Taki przeczytaliby go uczestnicy, a opublikowanej wersji nigdy się nie zmienia. Najpierw wstaw zatwierdzony tekst: edytuje go strona Protokoły.</translation>
    </message>
    <message>
        <source>Publish the draft</source>
        <translation>Opublikuj wersję roboczą</translation>
    </message>
    <message>
        <source>Do not publish</source>
        <translation>Nie publikuj</translation>
    </message>
    <message>
        <source>no time limit</source>
        <translation>bez limitu czasu</translation>
    </message>
</context>
<context>
    <name>Analysis</name>
    <message>
        <source>Construct validity</source>
        <translation>Trafność teoretyczna</translation>
    </message>
    <message>
        <source>Test-retest reliability</source>
        <translation>Rzetelność test-retest</translation>
    </message>
    <message>
        <source>Learning curves</source>
        <translation>Krzywe uczenia się</translation>
    </message>
    <message>
        <source>Agreement of raters</source>
        <translation>Zgodność oceniających</translation>
    </message>
    <message>
        <source>metric</source>
        <translation>miara</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>przedział 95 %</translation>
    </message>
    <message>
        <source>first</source>
        <translation>pierwszy</translation>
    </message>
    <message>
        <source>second</source>
        <translation>drugi</translation>
    </message>
    <message>
        <source>participant</source>
        <translation>uczestnik</translation>
    </message>
    <message>
        <source>attempts</source>
        <translation>próby</translation>
    </message>
    <message>
        <source>last</source>
        <translation>ostatnia</translation>
    </message>
    <message>
        <source>best</source>
        <translation>najlepsza</translation>
    </message>
    <message>
        <source>failures</source>
        <translation>niepowodzenia</translation>
    </message>
    <message>
        <source>plateau a</source>
        <translation>plateau a</translation>
    </message>
    <message>
        <source>plateau reached</source>
        <translation>plateau osiągnięte</translation>
    </message>
    <message>
        <source>rated</source>
        <translation>oceniane</translation>
    </message>
    <message>
        <source>raters</source>
        <translation>oceniający</translation>
    </message>
    <message>
        <source>There are no two levels with attempts of at least two people each.</source>
        <translation>Nie ma dwóch poziomów z próbami co najmniej dwóch osób.</translation>
    </message>
    <message>
        <source>At least three people with two attempts each at the same task are needed.</source>
        <translation>Potrzeba co najmniej trzech osób, z których każda wykonała to samo zadanie dwa razy.</translation>
    </message>
    <message>
        <source>There are no attempts yet.</source>
        <translation>Nie ma jeszcze żadnych prób.</translation>
    </message>
    <message>
        <source>There are attempts, but none of them counts.</source>
        <translation>Są próby, ale żadna się nie liczy.</translation>
    </message>
</context>
<context>
    <name>NamesCard</name>
    <message>
        <source>Names behind the codes</source>
        <translation>Nazwiska pod kodami</translation>
    </message>
    <message>
        <source>In a file of its own, apart from the data, encrypted under a passphrase. It is in no export and no backup of the store: keep a copy, and the passphrase elsewhere. Whoever loses the passphrase loses the names. Once there is a key, signatures under consents are sealed: only this file opens them.</source>
        <translation>W osobnym pliku, oddzielnie od danych, zaszyfrowane hasłem. Nie ma ich w żadnym eksporcie ani kopii bazy: proszę przechowywać kopię, a hasło w innym miejscu. Kto straci hasło, straci nazwiska. Odkąd jest klucz, podpisy pod zgodami są zapieczętowane: otwiera je tylko ten plik.</translation>
    </message>
    <message>
        <source>File of the key</source>
        <translation>Plik klucza</translation>
    </message>
    <message>
        <source>Passphrase, at least %1 characters</source>
        <translation>Hasło, co najmniej %1 znaków</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Otwórz</translation>
    </message>
    <message>
        <source>Make a new key</source>
        <translation>Utwórz nowy klucz</translation>
    </message>
    <message>
        <source>Making a key</source>
        <translation>Tworzenie klucza</translation>
    </message>
    <message>
        <source>Opening the key</source>
        <translation>Otwieranie klucza</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Kod</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nazwisko</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Uwaga</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Nazwiska</translation>
    </message>
    <message>
        <source>Keep the name</source>
        <translation>Zapisz nazwisko</translation>
    </message>
    <message>
        <source>Keeping a name</source>
        <translation>Zapisywanie nazwiska</translation>
    </message>
    <message>
        <source>Hide the names</source>
        <translation>Ukryj nazwiska</translation>
    </message>
    <message>
        <source>Signature under the consent of</source>
        <translation>Podpis pod zgodą</translation>
    </message>
    <message>
        <source>Sealed for another key: open the one of that time.</source>
        <translation>Zapieczętowano innym kluczem: proszę otworzyć klucz z tamtego czasu.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Pokaż</translation>
    </message>
    <message>
        <source>Showing a signature</source>
        <translation>Pokazywanie podpisu</translation>
    </message>
    <message>
        <source>These names belong to the study %1.</source>
        <translation>Te nazwiska należą do badania %1.</translation>
    </message>
    <message>
        <source>Reading the signatures</source>
        <translation>Odczyt podpisów</translation>
    </message>
</context>
<context>
    <name>ProtocolsPage</name>
    <message>
        <source>Protocols</source>
        <translation>Protokoły</translation>
    </message>
    <message>
        <source>Stay here</source>
        <translation>Zostań tutaj</translation>
    </message>
    <message>
        <source>A published version is never changed; a change is the next one.</source>
        <translation>Opublikowanej wersji nigdy się nie zmienia; zmiana to następna wersja.</translation>
    </message>
    <message>
        <source>Publish version %1?</source>
        <translation>Opublikować wersję %1?</translation>
    </message>
    <message>
        <source>Leave without saving?</source>
        <translation>Wyjść bez zapisania?</translation>
    </message>
    <message>
        <source>The text was changed and neither published nor exported.</source>
        <translation>Tekst został zmieniony, a nie został ani opublikowany, ani wyeksportowany.</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Wyjdź</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Rodzaj</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Badanie</translation>
    </message>
    <message>
        <source>Questionnaire</source>
        <translation>Kwestionariusz</translation>
    </message>
    <message>
        <source>Definition</source>
        <translation>Definicja</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nowy</translation>
    </message>
    <message>
        <source>%1, version %2, published</source>
        <translation>%1, wersja %2, opublikowana</translation>
    </message>
    <message>
        <source>%1, shipped</source>
        <translation>%1, dostarczony z programem</translation>
    </message>
    <message>
        <source>Opening the definition</source>
        <translation>Otwieranie definicji</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Kroki</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Pytania</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Dodaj</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>W górę</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>W dół</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Put it back</source>
        <translation>Przywróć</translation>
    </message>
    <message>
        <source>Removed: %1</source>
        <translation>Usunięto: %1</translation>
    </message>
    <message>
        <source>As a file (JSON)</source>
        <translation>Jako plik (JSON)</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importuj</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Eksportuj</translation>
    </message>
    <message>
        <source>Text of the definition</source>
        <translation>Tekst definicji</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Podgląd</translation>
    </message>
    <message>
        <source>Reason of the change</source>
        <translation>Powód zmiany</translation>
    </message>
    <message>
        <source>Reason of the change, from version 2 on</source>
        <translation>Powód zmiany, od wersji 2</translation>
    </message>
    <message>
        <source>Publish</source>
        <translation>Opublikuj</translation>
    </message>
    <message>
        <source>The study itself</source>
        <translation>Samo badanie</translation>
    </message>
    <message>
        <source>The questionnaire itself</source>
        <translation>Sam kwestionariusz</translation>
    </message>
    <message>
        <source>Information and consent</source>
        <translation>Informacja i zgoda</translation>
    </message>
    <message>
        <source>Arms</source>
        <translation>Grupy</translation>
    </message>
    <message>
        <source>No errors.</source>
        <translation>Brak błędów.</translation>
    </message>
    <message>
        <source>The form waits until the text can be read: %1</source>
        <translation>Formularz czeka, aż tekst da się odczytać: %1</translation>
    </message>
    <message>
        <source>Publishing</source>
        <translation>Publikowanie</translation>
    </message>
    <message>
        <source>%1 version %2 is published; it is never changed from now on.</source>
        <translation>%1, wersja %2 jest opublikowana; odtąd nigdy się nie zmieni.</translation>
    </message>
    <message>
        <source>Import a definition</source>
        <translation>Import definicji</translation>
    </message>
    <message>
        <source>Importing a definition</source>
        <translation>Importowanie definicji</translation>
    </message>
    <message>
        <source>Export the definition</source>
        <translation>Eksport definicji</translation>
    </message>
    <message>
        <source>Exporting the definition</source>
        <translation>Eksportowanie definicji</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Zapisano: %1</translation>
    </message>
</context>
<context>
    <name>StudyDataPage</name>
    <message>
        <source>Data</source>
        <translation>Dane</translation>
    </message>
    <message>
        <source>No study has participants yet. Enrol the first one on the page Studies.</source>
        <translation>Żadne badanie nie ma jeszcze uczestników. Pierwszego proszę włączyć na stronie Badania.</translation>
    </message>
    <message>
        <source>Participants: %1 · complete: %2 · locked: %3 · signed: %4 · differences between entries: %5 · corrections: %6</source>
        <translation>Uczestnicy: %1 · kompletni: %2 · zablokowani: %3 · podpisani: %4 · różnice między wprowadzeniami: %5 · poprawki: %6</translation>
    </message>
    <message>
        <source>open</source>
        <translation>otwarty</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>zablokowany</translation>
    </message>
    <message>
        <source>signed: %1, %2, %3</source>
        <translation>podpisany: %1, %2, %3</translation>
    </message>
    <message>
        <source>CHANGED AFTER THE SIGNATURE</source>
        <translation>ZMIENIONY PO PODPISANIU</translation>
    </message>
    <message>
        <source>Records</source>
        <translation>Rekordy</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Kod</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Kroki</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Odpowiedzi</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Rekord</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>Meaning: "reviewed and complete"</source>
        <translation>Znaczenie: „sprawdzono, kompletne”</translation>
    </message>
    <message>
        <source>Your password, again</source>
        <translation>Hasło, ponownie</translation>
    </message>
    <message>
        <source>Reason for unlocking</source>
        <translation>Powód odblokowania</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>Podpisz</translation>
    </message>
    <message>
        <source>Signing the record</source>
        <translation>Podpisywanie rekordu</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Odblokuj</translation>
    </message>
    <message>
        <source>Unlocking the record</source>
        <translation>Odblokowywanie rekordu</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Zablokuj</translation>
    </message>
    <message>
        <source>Locking the record</source>
        <translation>Blokowanie rekordu</translation>
    </message>
    <message>
        <source>Entry from paper</source>
        <translation>Wprowadzanie z papieru</translation>
    </message>
    <message>
        <source>Type a sheet twice, best by two people: Placode lists where the entries differ.</source>
        <translation>Arkusz należy wpisać dwa razy, najlepiej przez dwie osoby: Placode wymieni różnice.</translation>
    </message>
    <message>
        <source>Questionnaire</source>
        <translation>Kwestionariusz</translation>
    </message>
    <message>
        <source>Visit</source>
        <translation>Wizyta</translation>
    </message>
    <message>
        <source>Visit %1</source>
        <translation>Wizyta %1</translation>
    </message>
    <message>
        <source>%1, visit %2, %3</source>
        <translation>%1, wizyta %2, %3</translation>
    </message>
    <message>
        <source>%1  %2, visit %3, %4</source>
        <translation>%1  %2, wizyta %3, %4</translation>
    </message>
    <message>
        <source>Enter from paper</source>
        <translation>Wpisz z papieru</translation>
    </message>
    <message>
        <source>Enter a second time</source>
        <translation>Wpisz drugi raz</translation>
    </message>
    <message>
        <source>There are no open differences.</source>
        <translation>Nie ma otwartych różnic.</translation>
    </message>
    <message>
        <source>Reason: "looked at the sheet"</source>
        <translation>Powód: „sprawdzono na arkuszu”</translation>
    </message>
    <message>
        <source>The first is right</source>
        <translation>Pierwsze jest prawidłowe</translation>
    </message>
    <message>
        <source>The second is right</source>
        <translation>Drugie jest prawidłowe</translation>
    </message>
    <message>
        <source>There is no first entry.</source>
        <translation>Nie ma pierwszego wprowadzenia.</translation>
    </message>
    <message>
        <source>%1 has no answers to %2; enter the sheet from paper first.</source>
        <translation>%1 nie ma odpowiedzi na %2; najpierw proszę wpisać arkusz z papieru.</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>Pytanie</translation>
    </message>
    <message>
        <source>First entry</source>
        <translation>Pierwsze wprowadzenie</translation>
    </message>
    <message>
        <source>Second entry</source>
        <translation>Drugie wprowadzenie</translation>
    </message>
    <message>
        <source>Typed by</source>
        <translation>Wpisał(a)</translation>
    </message>
    <message>
        <source>Differences between entries</source>
        <translation>Różnice między wprowadzeniami</translation>
    </message>
    <message>
        <source>Deciding a difference</source>
        <translation>Rozstrzyganie różnicy</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>Poprawki</translation>
    </message>
    <message>
        <source>An answer is changed for a reason; the old one stays readable here.</source>
        <translation>Odpowiedź zmienia się z podaniem powodu; poprzednia pozostaje tu czytelna.</translation>
    </message>
    <message>
        <source>Answers of</source>
        <translation>Odpowiedzi</translation>
    </message>
    <message>
        <source>Item, e.g. A</source>
        <translation>Pytanie, np. A</translation>
    </message>
    <message>
        <source>New answer; empty takes it away</source>
        <translation>Nowa odpowiedź; puste usuwa</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Powód</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>Popraw</translation>
    </message>
    <message>
        <source>Correcting an answer</source>
        <translation>Poprawianie odpowiedzi</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Kiedy</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Kto</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Przed</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Po</translation>
    </message>
    <message>
        <source>Open the studies</source>
        <translation>Otwórz badania</translation>
    </message>
</context>
<context>
    <name>StudyParts</name>
    <message>
        <source>Study</source>
        <translation>Badanie</translation>
    </message>
</context>
<context>
    <name>StudyResultsPage</name>
    <message>
        <source>Figures</source>
        <translation>Ryciny</translation>
    </message>
    <message>
        <source>Construct validity</source>
        <translation>Trafność teoretyczna</translation>
    </message>
    <message>
        <source>Test-retest</source>
        <translation>Test-retest</translation>
    </message>
    <message>
        <source>Learning curves</source>
        <translation>Krzywe uczenia się</translation>
    </message>
    <message>
        <source>Raters</source>
        <translation>Oceniający</translation>
    </message>
    <message>
        <source>No study has participants yet. Enrol the first one on the page Studies.</source>
        <translation>Żadne badanie nie ma jeszcze uczestników. Pierwszego proszę włączyć na stronie Badania.</translation>
    </message>
    <message>
        <source>Reading the study …</source>
        <translation>Wczytywanie badania …</translation>
    </message>
    <message>
        <source>Reading the study</source>
        <translation>Wczytywanie badania</translation>
    </message>
    <message>
        <source>The study could not be read.</source>
        <translation>Nie udało się wczytać badania.</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Wyniki</translation>
    </message>
    <message>
        <source>Save figures and tables</source>
        <translation>Zapisz ryciny i tabele</translation>
    </message>
    <message>
        <source>What this sample can carry</source>
        <translation>Na co pozwala ta liczba osób</translation>
    </message>
    <message>
        <source>Levels by</source>
        <translation>Poziomy według</translation>
    </message>
    <message>
        <source>Save into this folder</source>
        <translation>Zapisz w tym folderze</translation>
    </message>
    <message>
        <source>Saving figures and tables</source>
        <translation>Zapisywanie rycin i tabel</translation>
    </message>
    <message>
        <source>Saving: %1</source>
        <translation>Zapisywanie: %1</translation>
    </message>
    <message>
        <source>Open the studies</source>
        <translation>Otwórz badania</translation>
    </message>
    <message>
        <source>All attempts count: %1.</source>
        <translation>Liczą się wszystkie próby: %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written: %1</source>
        <translation>
            <numerusform>Zapisano %n plik: %1</numerusform>
            <numerusform>Zapisano %n pliki: %1</numerusform>
            <numerusform>Zapisano %n plików: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>AdmissionsPage</name>
    <message>
        <source>Save the certificate of erasure</source>
        <translation>Zapisz zaświadczenie o usunięciu</translation>
    </message>
    <message>
        <source>Backups and other copies cleaned as well: %1.</source>
        <translation>Wyczyszczono też kopie zapasowe i inne kopie: %1.</translation>
    </message>
    <message>
        <source>These copies may still hold the person; delete them:</source>
        <translation>Te kopie mogą jeszcze zawierać dane tej osoby; usuń je:</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Tekst (*.txt)</translation>
    </message>
    <message>
        <source>Writing the certificate</source>
        <translation>Zapis zaświadczenia</translation>
    </message>
    <message>
        <source>Certificate written: %1</source>
        <translation>Zaświadczenie zapisane: %1</translation>
    </message>
    <message>
        <source>Invitations and requests</source>
        <translation>Zaproszenia i prośby</translation>
    </message>
    <message>
        <source>Invite somebody</source>
        <translation>Zaproś kogoś</translation>
    </message>
    <message>
        <source>For whom</source>
        <translation>Dla kogo</translation>
    </message>
    <message>
        <source>As</source>
        <translation>Jako</translation>
    </message>
    <message>
        <source>no group</source>
        <translation>bez grupy</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupa</translation>
    </message>
    <message>
        <source>Last day</source>
        <translation>Ostatni dzień</translation>
    </message>
    <message>
        <source>Make a code</source>
        <translation>Utwórz kod</translation>
    </message>
    <message>
        <source>Code of the invitation</source>
        <translation>Kod zaproszenia</translation>
    </message>
    <message>
        <source>The code is shown once: hand it over now. It works once, until its last day.</source>
        <translation>Kod jest pokazywany tylko raz: przekaż go teraz. Działa jeden raz, do ostatniego dnia.</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Utworzył</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>Użyto</translation>
    </message>
    <message>
        <source>Invitations</source>
        <translation>Zaproszenia</translation>
    </message>
    <message>
        <source>Inviting somebody</source>
        <translation>Zapraszanie</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>jeszcze nie</translation>
    </message>
    <message>
        <source>Take in a list</source>
        <translation>Wczytaj listę</translation>
    </message>
    <message>
        <source>A CSV file with the columns login, name and, if wanted, roles (separated by ;), group and password. The whole file is checked before the first account is made. Passwords that are missing are made and written into a file of your choice.</source>
        <translation>Plik CSV z kolumnami login, name oraz opcjonalnie roles (rozdzielone znakiem ;), group i password. Cały plik jest sprawdzany, zanim powstanie pierwsze konto. Brakujące hasła są tworzone i zapisywane w wybranym pliku.</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Wybierz plik</translation>
    </message>
    <message>
        <source>Taking in the list</source>
        <translation>Wczytywanie listy</translation>
    </message>
    <message>
        <source>Passwords that were made</source>
        <translation>Utworzone hasła</translation>
    </message>
    <message>
        <source>Added people: %1.</source>
        <translation>Dodane osoby: %1.</translation>
    </message>
    <message>
        <source>Who asks to be erased</source>
        <translation>Kto prosi o usunięcie</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Osoba</translation>
    </message>
    <message>
        <source>Asked</source>
        <translation>Prośba z</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Powód</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stan</translation>
    </message>
    <message>
        <source>The attempts go as well (else they stay, nameless)</source>
        <translation>Usuń także próby (inaczej zostają bez nazwiska)</translation>
    </message>
    <message>
        <source>Nobody has asked.</source>
        <translation>Nikt nie prosił.</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>numer %1</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>czeka</translation>
    </message>
    <message>
        <source>erased %1</source>
        <translation>usunięto %1</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Erase %1</source>
        <translation>Usuń: %1</translation>
    </message>
    <message>
        <source>Erase %1 for good?</source>
        <translation>Usunąć na zawsze: %1?</translation>
    </message>
    <message>
        <source>Name, log-in, groups, certificates and all attempts go. This cannot be undone.</source>
        <translation>Znikną imię i nazwisko, login, grupy, certyfikaty i wszystkie próby. Nie można tego cofnąć.</translation>
    </message>
    <message>
        <source>Name, log-in, groups and certificates go; attempts stay without a name. This cannot be undone.</source>
        <translation>Znikną imię i nazwisko, login, grupy i certyfikaty; próby zostaną bez nazwiska. Nie można tego cofnąć.</translation>
    </message>
    <message>
        <source>Erasing the person</source>
        <translation>Usuwanie osoby</translation>
    </message>
    <message>
        <source>%1 was erased.</source>
        <translation>Usunięto: %1.</translation>
    </message>
</context>
<context>
    <name>AssignCard</name>
    <message>
        <source>Type a name, or choose from the list</source>
        <translation>Wpisz nazwisko albo wybierz z listy</translation>
    </message>
    <message>
        <source>Assignments</source>
        <translation>Przydziały</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Komu</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Wersja</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Od</translation>
    </message>
    <message>
        <source>Due</source>
        <translation>Do</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stan</translation>
    </message>
    <message>
        <source>Nobody has this course yet. Choose a person or a group above.</source>
        <translation>Nikt jeszcze nie ma tego kursu. Wybierz powyżej osobę lub grupę.</translation>
    </message>
    <message>
        <source>Person or group</source>
        <translation>Osoba lub grupa</translation>
    </message>
    <message>
        <source>has an end</source>
        <translation>ma koniec</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Przydziel</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Grupa %1</translation>
    </message>
    <message>
        <source>Assigning the course</source>
        <translation>Przydzielanie kursu</translation>
    </message>
    <message>
        <source>There is nobody called "%1" whom you may assign a course; choose one of the list.</source>
        <translation>Nie ma nikogo o nazwie „%1”, komu możesz przydzielić kurs; wybierz z listy.</translation>
    </message>
    <message>
        <source>Assigned to %1.</source>
        <translation>Przydzielono: %1.</translation>
    </message>
    <message>
        <source>active</source>
        <translation>obowiązuje</translation>
    </message>
    <message>
        <source>ended %1</source>
        <translation>zakończony %1</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Zakończ</translation>
    </message>
    <message>
        <source>End the assignment to %1</source>
        <translation>Zakończ przydział: %1</translation>
    </message>
    <message>
        <source>End the assignment?</source>
        <translation>Zakończyć przydział?</translation>
    </message>
    <message>
        <source>%1 is no longer asked to do the course. Attempts and certificates stay.</source>
        <translation>%1: kurs nie będzie już wymagany. Próby i certyfikaty zostają.</translation>
    </message>
    <message>
        <source>Ending the assignment</source>
        <translation>Kończenie przydziału</translation>
    </message>
    <message>
        <source>The assignment has ended.</source>
        <translation>Przydział został zakończony.</translation>
    </message>
</context>
<context>
    <name>ComparePage</name>
    <message>
        <source>%1 · %2 · %3 pts</source>
        <translation>%1 · %2 · %3 pkt</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Porównaj</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Porównaj z</translation>
    </message>
    <message>
        <source>%1 · %2 · does not count</source>
        <translation>%1 · %2 · nie liczy się</translation>
    </message>
    <message>
        <source>Back to the result</source>
        <translation>Wróć do wyniku</translation>
    </message>
    <message>
        <source>There is no other attempt at this task yet. After the next one they can be compared.</source>
        <translation>Nie ma jeszcze innej próby tego zadania. Po następnej będzie można je porównać.</translation>
    </message>
    <message>
        <source>Reading the attempt</source>
        <translation>Odczyt próby</translation>
    </message>
    <message>
        <source>No points were lost</source>
        <translation>Nie stracono punktów</translation>
    </message>
    <message>
        <source>Does not count: %1</source>
        <translation>Nie liczy się: %1</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>Miary</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Miara</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Jednostka</translation>
    </message>
    <message>
        <source>This one</source>
        <translation>Ta próba</translation>
    </message>
    <message>
        <source>The other</source>
        <translation>Druga</translation>
    </message>
    <message>
        <source>Better</source>
        <translation>Lepsza</translation>
    </message>
    <message>
        <source>◀ this one</source>
        <translation>◀ ta próba</translation>
    </message>
    <message>
        <source>the other ▶</source>
        <translation>druga ▶</translation>
    </message>
    <message>
        <source>Reading the recordings …</source>
        <translation>Odczyt nagrań …</translation>
    </message>
    <message>
        <source>Reading the recordings</source>
        <translation>Odczyt nagrań</translation>
    </message>
    <message>
        <source>A recording cannot be shown.</source>
        <translation>Nagrania nie można pokazać.</translation>
    </message>
    <message>
        <source>Tool paths from above</source>
        <translation>Tor narzędzi z góry</translation>
    </message>
    <message>
        <source>Time lines, and paths from above</source>
        <translation>Osie czasu i tory z góry</translation>
    </message>
    <message>
        <source>Watch both</source>
        <translation>Obejrzyj obie</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>As operated</source>
        <translation>Jak podczas próby</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Z góry</translation>
    </message>
    <message>
        <source>From the left</source>
        <translation>Z lewej</translation>
    </message>
    <message>
        <source>From the feet</source>
        <translation>Od strony stóp</translation>
    </message>
    <message>
        <source>Near the tip</source>
        <translation>Blisko końcówki</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Prędkość</translation>
    </message>
    <message>
        <source>Speed %1×</source>
        <translation>Prędkość %1×</translation>
    </message>
    <message>
        <source>Close the windows</source>
        <translation>Zamknij okna</translation>
    </message>
    <message>
        <source>Moment of this one</source>
        <translation>Chwila tej próby</translation>
    </message>
    <message>
        <source>Moment of the other</source>
        <translation>Chwila drugiej</translation>
    </message>
    <message>
        <source>Both are simulated again exactly, each in a window of its own; camera, speed, pause and jumps on either time line act on both.</source>
        <translation>Obie są dokładnie symulowane od nowa, każda w swoim oknie; kamera, prędkość, pauza i skoki na każdej z osi czasu działają na obie.</translation>
    </message>
    <message>
        <source>Starting the replays</source>
        <translation>Uruchamianie odtwarzania</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Dalej</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pauza</translation>
    </message>
    <message>
        <source>One of the two was kept without a recording: measures can be compared, watching both needs two recordings.</source>
        <translation>Jedna z prób została zapisana bez nagrania: pomiary można porównać, obejrzenie obu wymaga dwóch nagrań.</translation>
    </message>
    <message>
        <source>One of the two does not count: its measures stand here without a verdict on which is better.</source>
        <translation>Jedna z prób się nie liczy: jej miary stoją tu bez oceny, która jest lepsza.</translation>
    </message>
</context>
<context>
    <name>CourseEditorPage</name>
    <message>
        <source>Course editor</source>
        <translation>Edytor kursu</translation>
    </message>
    <message>
        <source>Stay here</source>
        <translation>Zostań tutaj</translation>
    </message>
    <message>
        <source>Leave the course unpublished?</source>
        <translation>Zostawić kurs nieopublikowany?</translation>
    </message>
    <message>
        <source>What you changed since it was opened or exported is lost.</source>
        <translation>Zmiany od otwarcia lub eksportu zostaną utracone.</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Wyjdź</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Cofnij</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Ponów</translation>
    </message>
    <message>
        <source>Export as a file</source>
        <translation>Eksportuj do pliku</translation>
    </message>
    <message>
        <source>Title, English</source>
        <translation>Tytuł, angielski</translation>
    </message>
    <message>
        <source>Title, Polish</source>
        <translation>Tytuł, polski</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Identyfikator</translation>
    </message>
    <message>
        <source>Description, English</source>
        <translation>Opis, angielski</translation>
    </message>
    <message>
        <source>Description, Polish</source>
        <translation>Opis, polski</translation>
    </message>
    <message>
        <source>Stages in order</source>
        <translation>Etapy po kolei</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Dodaj</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>W górę</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>W dół</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Preview: the first day of a trainee</source>
        <translation>Podgląd: pierwszy dzień kursanta</translation>
    </message>
    <message>
        <source>What changed, and why</source>
        <translation>Co się zmieniło i dlaczego</translation>
    </message>
    <message>
        <source>Reason (needed from version 2 on)</source>
        <translation>Powód (wymagany od wersji 2)</translation>
    </message>
    <message>
        <source>open</source>
        <translation>otwarty</translation>
    </message>
    <message>
        <source>opens when mastered: %1</source>
        <translation>otwiera się po zaliczeniu: %1</translation>
    </message>
    <message>
        <source>Publish version %1</source>
        <translation>Opublikuj wersję %1</translation>
    </message>
    <message>
        <source>Not yet: %1</source>
        <translation>Jeszcze nie: %1</translation>
    </message>
    <message>
        <source>Not yet: give the reason of the change.</source>
        <translation>Jeszcze nie: podaj powód zmiany.</translation>
    </message>
    <message>
        <source>No problems found. A published version is never changed; a change is the next one.</source>
        <translation>Nie znaleziono błędów. Opublikowanej wersji nigdy się nie zmienia; zmiana to następna wersja.</translation>
    </message>
    <message>
        <source>stage %1: %2</source>
        <translation>etap %1: %2</translation>
    </message>
    <message>
        <source>Publishing the course</source>
        <translation>Publikowanie kursu</translation>
    </message>
    <message>
        <source>%1, version %2, is published. Assign it to people or groups.</source>
        <translation>%1, wersja %2: opublikowano. Przydziel kurs osobom lub grupom.</translation>
    </message>
    <message>
        <source>Export the course</source>
        <translation>Eksport kursu</translation>
    </message>
    <message>
        <source>Exporting the course</source>
        <translation>Eksportowanie kursu</translation>
    </message>
    <message>
        <source>Course written: %1</source>
        <translation>Zapisano kurs: %1</translation>
    </message>
    <message>
        <source>What a trainee sees first appears here.</source>
        <translation>Tu będzie widać to, co zobaczy kursant.</translation>
    </message>
    <message>
        <source>Publish version %1?</source>
        <translation>Opublikować wersję %1?</translation>
    </message>
    <message>
        <source>A published version is never changed; a change is the next one.</source>
        <translation>Opublikowanej wersji nigdy się nie zmienia; zmiana to następna wersja.</translation>
    </message>
    <message>
        <source>There are no stages yet. Press Add: a stage is one task, with what counts as mastered. Trainees go from the first to the last.</source>
        <translation>Nie ma jeszcze etapów. Naciśnij Dodaj: etap to jedno zadanie i to, co liczy się jako opanowanie. Uczestnicy przechodzą od pierwszego do ostatniego.</translation>
    </message>
</context>
<context>
    <name>CourseWords</name>
    <message>
        <source>Familiarisation</source>
        <translation>Zapoznanie</translation>
    </message>
    <message>
        <source>Exam</source>
        <translation>Egzamin</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Ćwiczenie</translation>
    </message>
    <message>
        <source>Counts whatever the score</source>
        <translation>Liczy się niezależnie od wyniku</translation>
    </message>
    <message>
        <source>attempts at most: %1</source>
        <translation>najwyżej prób: %1</translation>
    </message>
    <message>
        <source>No help, no planned line, no read-outs but the time</source>
        <translation>Bez pomocy, bez planowanej linii, bez wskaźników poza czasem</translation>
    </message>
    <message numerus="yes">
        <source>%n fixed case(s), one after the other, then from the first</source>
        <translation>
            <numerusform>%n stały przypadek</numerusform>
            <numerusform>%n stałe przypadki, jeden po drugim, potem od pierwszego</numerusform>
            <numerusform>%n stałych przypadków, jeden po drugim, potem od pierwszego</numerusform>
        </translation>
    </message>
    <message>
        <source>one fixed case</source>
        <translation>jeden stały przypadek</translation>
    </message>
    <message>
        <source>a proctor confirms that the exam may begin</source>
        <translation>osoba nadzorująca potwierdza rozpoczęcie</translation>
    </message>
    <message>
        <source>only on a haptic device, whose loop must stay sound</source>
        <translation>tylko na urządzeniu haptycznym, którego pętla musi pozostać sprawna</translation>
    </message>
    <message>
        <source>"%1" is no id: use letters, digits, _ . and - only.</source>
        <translation>„%1” nie jest identyfikatorem: używaj tylko liter, cyfr, _ . i -.</translation>
    </message>
    <message>
        <source>The English title is missing.</source>
        <translation>Brakuje angielskiego tytułu.</translation>
    </message>
    <message>
        <source>A course has 1 to 100 stages. Add one.</source>
        <translation>Kurs ma od 1 do 100 etapów. Dodaj etap.</translation>
    </message>
    <message>
        <source>There is no task "%1". Choose one of the list.</source>
        <translation>Nie ma zadania „%1”. Wybierz z listy.</translation>
    </message>
    <message>
        <source>"%1" is the id of another stage already.</source>
        <translation>„%1” jest już identyfikatorem innego etapu.</translation>
    </message>
    <message>
        <source>"%1" is not an earlier stage.</source>
        <translation>„%1” nie jest wcześniejszym etapem.</translation>
    </message>
    <message>
        <source>A benchmark is 0 to 100 points.</source>
        <translation>Próg to od 0 do 100 punktów.</translation>
    </message>
    <message>
        <source>In a row: 1 to 20 times.</source>
        <translation>Z rzędu: od 1 do 20 razy.</translation>
    </message>
    <message>
        <source>0 to 3650 days.</source>
        <translation>Od 0 do 3650 dni.</translation>
    </message>
    <message>
        <source>An exam needs its list of cases: 1 to 100 whole numbers.</source>
        <translation>Egzamin wymaga listy przypadków: od 1 do 100 liczb całkowitych.</translation>
    </message>
    <message>
        <source>%1 stands twice in the list.</source>
        <translation>%1 występuje na liście dwa razy.</translation>
    </message>
    <message numerus="yes">
        <source>Benchmark %n point(s), once</source>
        <translation>
            <numerusform>Próg %n punkt, jeden raz</numerusform>
            <numerusform>Próg %n punkty, jeden raz</numerusform>
            <numerusform>Próg %n punktów, jeden raz</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Benchmark %n point(s), %1 times in a row</source>
        <translation>
            <numerusform>Próg %n punkt, %1 razy z rzędu</numerusform>
            <numerusform>Próg %n punkty, %1 razy z rzędu</numerusform>
            <numerusform>Próg %n punktów, %1 razy z rzędu</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>to be refreshed after %n day(s)</source>
        <translation>
            <numerusform>do odświeżenia po %n dniu</numerusform>
            <numerusform>do odświeżenia po %n dniach</numerusform>
            <numerusform>do odświeżenia po %n dniach</numerusform>
        </translation>
    </message>
    <message>
        <source>Only an exam has a limit of attempts, not %1 at practice. Choose 0: no limit.</source>
        <translation>Tylko egzamin ma limit prób, a nie %1 w ćwiczeniu. Wybierz 0: bez limitu.</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) are fewer than what is wanted in a row: it could never be mastered.</source>
        <translation>
            <numerusform>%n próba to mniej niż wymagane z rzędu: etapu nie dałoby się zaliczyć.</numerusform>
            <numerusform>%n próby to mniej niż wymagane z rzędu: etapu nie dałoby się zaliczyć.</numerusform>
            <numerusform>%n prób to mniej niż wymagane z rzędu: etapu nie dałoby się zaliczyć.</numerusform>
        </translation>
    </message>
    <message>
        <source>leaving uses up an attempt</source>
        <translation>wyjście zużywa próbę</translation>
    </message>
</context>
<context>
    <name>CoursesPage</name>
    <message>
        <source>Courses of the centre</source>
        <translation>Kursy ośrodka</translation>
    </message>
    <message>
        <source>Import a file</source>
        <translation>Importuj plik</translation>
    </message>
    <message>
        <source>New course</source>
        <translation>Nowy kurs</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Identyfikator</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Wersja</translation>
    </message>
    <message>
        <source>Stages</source>
        <translation>Etapy</translation>
    </message>
    <message>
        <source>Published</source>
        <translation>Opublikowano</translation>
    </message>
    <message>
        <source>Courses</source>
        <translation>Wszystkie kursy</translation>
    </message>
    <message>
        <source>came with the program</source>
        <translation>dostarczony z programem</translation>
    </message>
    <message>
        <source>Reading the course</source>
        <translation>Czytanie kursu</translation>
    </message>
    <message>
        <source>Change into the next version</source>
        <translation>Utwórz następną wersję</translation>
    </message>
    <message>
        <source>Import a course</source>
        <translation>Import kursu</translation>
    </message>
    <message>
        <source>Importing the course</source>
        <translation>Importowanie kursu</translation>
    </message>
</context>
<context>
    <name>GroupsPage</name>
    <message>
        <source>Groups</source>
        <translation>Grupy</translation>
    </message>
    <message>
        <source>New group</source>
        <translation>Nowa grupa</translation>
    </message>
    <message>
        <source>Add the group</source>
        <translation>Dodaj grupę</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupa</translation>
    </message>
    <message>
        <source>Adding the group</source>
        <translation>Dodawanie grupy</translation>
    </message>
    <message>
        <source>There are no groups yet. Give one a name above; courses can then be assigned to all of it at once, and its educators see who is stuck.</source>
        <translation>Nie ma jeszcze grup. Nadaj powyżej nazwę; kursy można wtedy przydzielać całej grupie naraz, a jej instruktorzy widzą, kto utknął.</translation>
    </message>
    <message>
        <source>Only an educator of this group or an administrator may change it.</source>
        <translation>Zmienić ją może tylko instruktor tej grupy lub administrator.</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Osoba</translation>
    </message>
    <message>
        <source>member</source>
        <translation>członek</translation>
    </message>
    <message>
        <source>educator</source>
        <translation>instruktor</translation>
    </message>
    <message>
        <source>As</source>
        <translation>Jako</translation>
    </message>
    <message>
        <source>Put into the group</source>
        <translation>Dodaj do grupy</translation>
    </message>
    <message>
        <source>Type a name, or choose from the list</source>
        <translation>Wpisz nazwisko albo wybierz z listy</translation>
    </message>
    <message>
        <source>There is nobody called &quot;%1&quot;; choose one of the list.</source>
        <translation>Nie ma osoby o nazwie „%1”; wybierz kogoś z listy.</translation>
    </message>
    <message>
        <source>%1 is in the group now.</source>
        <translation>%1 należy teraz do grupy.</translation>
    </message>
    <message>
        <source>Log-in name</source>
        <translation>Login</translation>
    </message>
    <message>
        <source>In the group</source>
        <translation>W grupie</translation>
    </message>
    <message>
        <source>Changing the group</source>
        <translation>Zmienianie grupy</translation>
    </message>
    <message>
        <source>%1 has not the role educator; an administrator can give it.</source>
        <translation>%1 nie ma roli instruktora; może ją nadać administrator.</translation>
    </message>
    <message>
        <source>Take out of the group</source>
        <translation>Usuń z grupy</translation>
    </message>
</context>
<context>
    <name>JoinPage</name>
    <message>
        <source>Make your account</source>
        <translation>Załóż konto</translation>
    </message>
    <message>
        <source>Type the code that you were given. Name and password are yours to choose.</source>
        <translation>Wpisz otrzymany kod. Nazwę i hasło wybierasz samodzielnie.</translation>
    </message>
    <message>
        <source>Make the account</source>
        <translation>Załóż konto</translation>
    </message>
    <message>
        <source>Back to sign in</source>
        <translation>Wróć do logowania</translation>
    </message>
    <message>
        <source>Code of the invitation</source>
        <translation>Kod zaproszenia</translation>
    </message>
    <message>
        <source>Making the account</source>
        <translation>Zakładanie konta</translation>
    </message>
    <message>
        <source>Your account is made. Sign in with it.</source>
        <translation>Konto jest gotowe. Zaloguj się.</translation>
    </message>
    <message>
        <source>Type the code of the invitation.</source>
        <translation>Wpisz kod z zaproszenia.</translation>
    </message>
</context>
<context>
    <name>NormsPage</name>
    <message>
        <source>Norms</source>
        <translation>Normy</translation>
    </message>
    <message>
        <source>Import a pack</source>
        <translation>Importuj pakiet</translation>
    </message>
    <message>
        <source>A pack holds bands of a task (means and spreads of people, never of fewer than %1 and never a single attempt), signed by its centre. The pack in use is shown behind every attempt of the task. Packs of this centre are made on the page Standards.</source>
        <translation>Pakiet zawiera pasma zadania (średnie i rozrzuty osób, nigdy mniej niż %1 i nigdy pojedynczej próby) podpisane przez ośrodek. Używany pakiet jest pokazywany w tle wyniku każdej próby tego zadania. Pakiety tego ośrodka powstają na stronie Progi.</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Zadanie</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Ośrodek</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Utworzono</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Grupy</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Klucz</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Użycie</translation>
    </message>
    <message>
        <source>There are no packs yet. Import one of another centre, or make one from two groups on the page Standards.</source>
        <translation>Nie ma jeszcze pakietów. Zaimportuj pakiet innego ośrodka lub utwórz własny z dwóch grup na stronie Progi.</translation>
    </message>
    <message>
        <source>Use for its task</source>
        <translation>Używaj dla zadania</translation>
    </message>
    <message>
        <source>Export the pack</source>
        <translation>Eksportuj pakiet</translation>
    </message>
    <message>
        <source>%1 (people: %2)</source>
        <translation>%1 (%2 os.)</translation>
    </message>
    <message>
        <source>DEMONSTRATION</source>
        <translation>DEMONSTRACJA</translation>
    </message>
    <message>
        <source>in use</source>
        <translation>w użyciu</translation>
    </message>
    <message>
        <source>Using the pack</source>
        <translation>Używanie pakietu</translation>
    </message>
    <message>
        <source>Exporting the pack</source>
        <translation>Eksportowanie pakietu</translation>
    </message>
    <message>
        <source>Pack written: %1</source>
        <translation>Zapisano pakiet: %1</translation>
    </message>
    <message>
        <source>Importing the pack</source>
        <translation>Importowanie pakietu</translation>
    </message>
    <message>
        <source>%1: the signature is wrong: the pack was changed after it was signed. Ask the centre for it again.</source>
        <translation>%1: podpis jest błędny: pakiet zmieniono po podpisaniu. Poproś ośrodek o ponowne przysłanie.</translation>
    </message>
    <message>
        <source>Trust %1?</source>
        <translation>Zaufać: %1?</translation>
    </message>
    <message>
        <source>Its key is %1. Compare it with the centre by telephone before you trust it.</source>
        <translation>Jego klucz to %1. Zanim zaufasz, porównaj go z ośrodkiem przez telefon.</translation>
    </message>
    <message>
        <source>Trust this key</source>
        <translation>Zaufaj kluczowi</translation>
    </message>
    <message>
        <source>The pack of %1 was imported.</source>
        <translation>Zaimportowano pakiet: %1.</translation>
    </message>
    <message>
        <source>experts</source>
        <translation>eksperci</translation>
    </message>
    <message>
        <source>novices</source>
        <translation>początkujący</translation>
    </message>
</context>
<context>
    <name>StageWords</name>
    <message>
        <source>Stage</source>
        <translation>Etap</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Zadanie</translation>
    </message>
    <message>
        <source>Id of the stage</source>
        <translation>Identyfikator etapu</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Tryb</translation>
    </message>
    <message>
        <source>Benchmark [points]</source>
        <translation>Próg [pkt]</translation>
    </message>
    <message>
        <source>Times in a row</source>
        <translation>Razy z rzędu</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>bez limitu</translation>
    </message>
    <message>
        <source>Attempts at most</source>
        <translation>Najwyżej prób</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nigdy</translation>
    </message>
    <message>
        <source>Refresh after [days]</source>
        <translation>Odświeżyć po [dni]</translation>
    </message>
    <message>
        <source>Opens when these are mastered</source>
        <translation>Otwiera się po zaliczeniu</translation>
    </message>
    <message>
        <source>Cases of the exam (seeds, used in this order)</source>
        <translation>Przypadki egzaminu (ziarna, w tej kolejności)</translation>
    </message>
    <message>
        <source>A proctor confirms that it may begin</source>
        <translation>Osoba nadzorująca potwierdza rozpoczęcie</translation>
    </message>
    <message>
        <source>Only on a certified haptic device</source>
        <translation>Tylko na certyfikowanym urządzeniu haptycznym</translation>
    </message>
    <message>
        <source>"%1" is no whole number; write them with commas.</source>
        <translation>„%1” nie jest liczbą całkowitą; rozdziel liczby przecinkami.</translation>
    </message>
    <message>
        <source>The first stage is open from the start.</source>
        <translation>Pierwszy etap jest otwarty od początku.</translation>
    </message>
</context>
<context>
    <name>AngoffCard</name>
    <message>
        <source>Judges' estimates (Angoff)</source>
        <translation>Oszacowania sędziów (Angoff)</translation>
    </message>
    <message>
        <source>Of 100 trainees who are just good enough: how many lose nothing at this line? Every judge fills a column alone; a line counts by the most points it can take.</source>
        <translation>Na 100 osób, których umiejętności ledwie wystarczają do zaliczenia: ile nie straci punktów w tym wierszu? Każdy sędzia wypełnia swoją kolumnę sam; wiersz liczy się według największej liczby punktów, jaką może zabrać.</translation>
    </message>
    <message>
        <source>Judges</source>
        <translation>Sędziowie</translation>
    </message>
    <message>
        <source>Line of the rubric</source>
        <translation>Wiersz kryteriów</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Najwyżej</translation>
    </message>
    <message>
        <source>Estimates of the judges, 0 to 100</source>
        <translation>Oszacowania sędziów, od 0 do 100</translation>
    </message>
    <message>
        <source>Reason (needed from the second one on)</source>
        <translation>Powód (wymagany od drugiego)</translation>
    </message>
    <message>
        <source>Set as the standard</source>
        <translation>Ustal jako standard</translation>
    </message>
    <message>
        <source>Judge %1</source>
        <translation>Sędzia %1</translation>
    </message>
    <message>
        <source>Judge %1, "%2": %3 is no number from 0 to 100.</source>
        <translation>Sędzia %1, „%2”: %3 nie jest liczbą od 0 do 100.</translation>
    </message>
    <message>
        <source>Estimates that are missing: %1</source>
        <translation>Brakujące oszacowania: %1</translation>
    </message>
    <message>
        <source>This task's rubric has no lines.</source>
        <translation>Kryteria tego zadania nie mają wierszy.</translation>
    </message>
    <message>
        <source>Pass mark: %1 points</source>
        <translation>Próg zaliczenia: %1 pkt</translation>
    </message>
    <message>
        <source>Judges: %1, standard deviation between them %2, standard error %3 points.</source>
        <translation>Sędziowie: %1, odchylenie standardowe między nimi %2, błąd standardowy %3 pkt.</translation>
    </message>
    <message>
        <source>Fewer than %1 judges: a first orientation.</source>
        <translation>Mniej niż %1 sędziów: tylko wstępna orientacja.</translation>
    </message>
</context>
<context>
    <name>QualityCard</name>
    <message>
        <source>Quality of the metrics</source>
        <translation>Jakość miar</translation>
    </message>
    <message>
        <source>A metric has evidence when experts differ from novices (the interval of Hedges' g is above 0), when it repeats (ICC of %1 attempts a person at least 0.5), and when at most 20 % of the values are at its best one.</source>
        <translation>Miara jest potwierdzona, gdy eksperci różnią się od początkujących (przedział g Hedgesa powyżej 0), gdy jest powtarzalna (ICC z %1 prób na osobę co najmniej 0,5) i gdy najwyżej 20 % wartości jest najlepszych z możliwych.</translation>
    </message>
    <message>
        <source>Choose at least two novices and two experts; scripted operators do not count.</source>
        <translation>Wybierz co najmniej dwóch początkujących i dwóch ekspertów; operatorzy skryptowi się nie liczą.</translation>
    </message>
    <message>
        <source>Show the panel</source>
        <translation>Pokaż zestawienie</translation>
    </message>
    <message>
        <source>Reading the metrics of these people</source>
        <translation>Czytanie miar tych osób</translation>
    </message>
    <message>
        <source>does not tell the groups apart</source>
        <translation>nie odróżnia grup</translation>
    </message>
    <message>
        <source>does not repeat</source>
        <translation>nie jest powtarzalna</translation>
    </message>
    <message>
        <source>too few repeats to know</source>
        <translation>za mało powtórzeń, by wiedzieć</translation>
    </message>
    <message>
        <source>is at its best value too often</source>
        <translation>zbyt często osiąga najlepszą wartość</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Miara</translation>
    </message>
    <message>
        <source>Hedges' g</source>
        <translation>g Hedgesa</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>Przedział 95 %</translation>
    </message>
    <message>
        <source>ICC(2,1)</source>
        <translation>ICC(2,1)</translation>
    </message>
    <message>
        <source>At the best [%]</source>
        <translation>Najlepsze [%]</translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation>Potwierdzenie</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkty</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 do %2</translation>
    </message>
    <message>
        <source>✓ yes</source>
        <translation>✓ tak</translation>
    </message>
    <message>
        <source>▲ no: %1</source>
        <translation>▲ nie: %1</translation>
    </message>
    <message>
        <source>Metrics: %1, without evidence: %2. A metric without evidence should weigh nothing in a rubric: take its line out, publish the rubric's next version and score the attempts again.</source>
        <translation>Miary: %1, bez potwierdzenia: %2. Miara bez potwierdzenia nie powinna nic ważyć w kryteriach: usuń jej wiersz, opublikuj następną wersję kryteriów i oceń próby ponownie.</translation>
    </message>
</context>
<context>
    <name>ExportButtons</name>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Cancelled; nothing was written.</source>
        <translation>Przerwano; niczego nie zapisano.</translation>
    </message>
</context>
<context>
    <name>ExportFormat</name>
    <message>
        <source>CSV (wide, long, codebook)</source>
        <translation>CSV (tabela szeroka i długa, opis zmiennych)</translation>
    </message>
    <message>
        <source>SPSS (.sav)</source>
        <translation>SPSS (.sav)</translation>
    </message>
    <message>
        <source>REDCap (dictionary and records)</source>
        <translation>REDCap (słownik i rekordy)</translation>
    </message>
    <message>
        <source>FHIR R4 (Questionnaire, QuestionnaireResponse)</source>
        <translation>FHIR R4 (kwestionariusz i odpowiedzi)</translation>
    </message>
    <message>
        <source>CDISC ODM 1.3.2</source>
        <translation>CDISC ODM 1.3.2</translation>
    </message>
    <message>
        <source>xAPI statements</source>
        <translation>xAPI (zdania o aktywności)</translation>
    </message>
    <message>
        <source>Motion-BIDS (trajectories)</source>
        <translation>Motion-BIDS (trajektorie)</translation>
    </message>
    <message>
        <source>All of these with manifest and checksums</source>
        <translation>Wszystkie, ze spisem i sumami kontrolnymi</translation>
    </message>
</context>
<context>
    <name>Deviation</name>
    <message>
        <source>practice, not verified: %1</source>
        <translation>ćwiczenie, niezweryfikowane: %1</translation>
    </message>
    <message>
        <source>still to be simulated again: %1</source>
        <translation>czekają na ponowną symulację: %1</translation>
    </message>
    <message>
        <source>menu</source>
        <translation>menu</translation>
    </message>
    <message>
        <source>help</source>
        <translation>pomoc</translation>
    </message>
    <message>
        <source>asked before closing</source>
        <translation>pytanie przed zamknięciem</translation>
    </message>
    <message>
        <source>another window in front</source>
        <translation>inne okno na wierzchu</translation>
    </message>
    <message>
        <source>the device was gone</source>
        <translation>brak urządzenia</translation>
    </message>
    <message>
        <source>the computer was asleep</source>
        <translation>uśpienie komputera</translation>
    </message>
    <message>
        <source>Stood still %1, %2 in all (%3).</source>
        <translation>Czas stał %1, łącznie %2 (%3).</translation>
    </message>
    <message>
        <source>The computer fell behind %1, %2 in all.</source>
        <translation>Komputer nie nadążał %1, łącznie %2.</translation>
    </message>
    <message>
        <source>Does not count: %1.</source>
        <translation>Nie liczy się: %1.</translation>
    </message>
    <message>
        <source>Ended after %1; the protocol asks for at least %2.</source>
        <translation>Zakończono po %1; protokół wymaga co najmniej %2.</translation>
    </message>
    <message>
        <source>Broken off after %1.</source>
        <translation>Przerwano po %1.</translation>
    </message>
    <message>
        <source>Done again; this attempt is kept and does not count. Reason: %1</source>
        <translation>Powtórzono; ta próba jest zachowana i nie liczy się. Powód: %1</translation>
    </message>
    <message>
        <source>Done with %1; %2 was set.</source>
        <translation>Wykonano urządzeniem %1; ustalono %2.</translation>
    </message>
    <message>
        <source>Skipped.</source>
        <translation>Pominięto.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>once</source>
        <translation>raz</translation>
    </message>
    <message>
        <source>twice</source>
        <translation>dwa razy</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 razy</translation>
    </message>
    <message>
        <source>broken off</source>
        <translation>przerwano</translation>
    </message>
    <message>
        <source>it ended after %1 s, before %2 s were over</source>
        <translation>zakończono po %1 s, przed upływem %2 s</translation>
    </message>
    <message>
        <source>The computer was too slow: the simulation ran at %1 % of real time, 95 % are needed</source>
        <translation>Komputer był za wolny: symulacja szła z szybkością %1 % czasu rzeczywistego, potrzeba 95 %</translation>
    </message>
    <message>
        <source>the simulation ran at %1 % of real time, 95 % are needed</source>
        <translation>symulacja szła z szybkością %1 % czasu rzeczywistego, potrzeba 95 %</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Przerwy</translation>
    </message>
    <message>
        <source>Slow computer</source>
        <translation>Wolny komputer</translation>
    </message>
    <message>
        <source>Ended too early</source>
        <translation>Zakończono za wcześnie</translation>
    </message>
    <message>
        <source>Broken off</source>
        <translation>Przerwano</translation>
    </message>
    <message>
        <source>Done again</source>
        <translation>Powtórzono</translation>
    </message>
    <message>
        <source>Another device</source>
        <translation>Inne urządzenie</translation>
    </message>
    <message>
        <source>Step skipped</source>
        <translation>Pominięty krok</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Uwaga</translation>
    </message>
    <message>
        <source>Attempts that do not count: %1 of %2 (%3).</source>
        <translation>Próby, które się nie liczą: %1 z %2 (%3).</translation>
    </message>
    <message>
        <source>void, the computer too slow or a device at fault: %1</source>
        <translation>nieważne, za wolny komputer lub wadliwe urządzenie: %1</translation>
    </message>
    <message>
        <source>broken off: %1</source>
        <translation>przerwane: %1</translation>
    </message>
    <message>
        <source>done again: %1</source>
        <translation>powtórzone: %1</translation>
    </message>
    <message>
        <source>shorter than the protocol asks: %1</source>
        <translation>krótsze, niż wymaga protokół: %1</translation>
    </message>
    <message>
        <source>nothing was done: %1</source>
        <translation>nic nie zrobiono: %1</translation>
    </message>
    <message numerus="yes">
        <source>The computer was too slow: %n picture(s) a second, 20 are needed</source>
        <translation>
            <numerusform>Komputer był za wolny: %n obraz na sekundę, potrzeba 20</numerusform>
            <numerusform>Komputer był za wolny: %n obrazy na sekundę, potrzeba 20</numerusform>
            <numerusform>Komputer był za wolny: %n obrazów na sekundę, potrzeba 20</numerusform>
        </translation>
    </message>
    <message>
        <source>left after %1</source>
        <translation>przerwana po %1</translation>
    </message>
    <message>
        <source>nothing was done</source>
        <translation>nic nie zrobiono</translation>
    </message>
    <message>
        <source>Tissue or generator was tuned</source>
        <translation>Tkanka lub generator były strojone</translation>
    </message>
    <message>
        <source>Begun at stage %1, what came before it was given</source>
        <translation>Rozpoczęta od etapu %1, to, co przed nim, było gotowe</translation>
    </message>
    <message>
        <source>Nothing was done in %1; the attempt is kept and no analysis uses it.</source>
        <translation>Przez %1 nic nie zrobiono; próba zostaje, lecz żadna analiza jej nie używa.</translation>
    </message>
    <message>
        <source>Nothing was done</source>
        <translation>Nic nie zrobiono</translation>
    </message>
    <message>
        <source>tissue or generator was tuned</source>
        <translation>strojono tkankę lub generator</translation>
    </message>
    <message>
        <source>begun at stage %1</source>
        <translation>rozpoczęta od etapu %1</translation>
    </message>
    <message>
        <source>the force device did not work as it must</source>
        <translation>urządzenie haptyczne nie działało prawidłowo</translation>
    </message>
    <message>
        <source>the computer was too slow</source>
        <translation>komputer był za wolny</translation>
    </message>
    <message>
        <source>Practice, not verified: no task %1 is published here</source>
        <translation>Ćwiczenie, niezweryfikowane: nie opublikowano tu zadania %1</translation>
    </message>
    <message>
        <source>Practice, not verified: its task is not the published %1</source>
        <translation>Ćwiczenie, niezweryfikowane: jego zadanie nie jest opublikowanym %1</translation>
    </message>
    <message>
        <source>Practice, not verified: it cannot be scored (%1)</source>
        <translation>Ćwiczenie, niezweryfikowane: nie można go ocenić (%1)</translation>
    </message>
    <message>
        <source>Practice, not verified: attempt %1 is the same recording</source>
        <translation>Ćwiczenie, niezweryfikowane: próba %1 jest tym samym nagraniem</translation>
    </message>
    <message>
        <source>Practice, not verified: simulated again it differs (%1)</source>
        <translation>Ćwiczenie, niezweryfikowane: ponowna symulacja dała inny wynik (%1)</translation>
    </message>
    <message>
        <source>Practice, not verified: no computer signed the recording, or it was changed</source>
        <translation>Ćwiczenie, niezweryfikowane: nagrania nie podpisał żaden komputer albo je zmieniono</translation>
    </message>
    <message>
        <source>Practice, not verified: the computer %1 recorded it, which no administrator has vouched for</source>
        <translation>Ćwiczenie, niezweryfikowane: nagrał je komputer %1, za który nie ręczył żaden administrator</translation>
    </message>
    <message>
        <source>Practice, not verified: operated by %1</source>
        <translation>Ćwiczenie, niezweryfikowane: operował %1</translation>
    </message>
    <message>
        <source>Practice, not verified: nothing was recorded</source>
        <translation>Ćwiczenie, niezweryfikowane: niczego nie nagrano</translation>
    </message>
    <message>
        <source>Practice, not verified: it was begun for another person, exam or proctor</source>
        <translation>Ćwiczenie, niezweryfikowane: próbę rozpoczęto dla innej osoby, innego egzaminu lub innej osoby nadzorującej</translation>
    </message>
    <message>
        <source>Practice, not verified: nothing shows for whom and for which exam it was begun</source>
        <translation>Ćwiczenie, niezweryfikowane: nie wiadomo, dla kogo i dla jakiego egzaminu próbę rozpoczęto</translation>
    </message>
    <message>
        <source>Practice, not verified: the proctor is the person examined, or neither educator nor administrator here</source>
        <translation>Ćwiczenie, niezweryfikowane: osoba nadzorująca jest osobą egzaminowaną albo nie jest tu instruktorem ani administratorem</translation>
    </message>
    <message>
        <source>practice, not verified</source>
        <translation>ćwiczenie, niezweryfikowane</translation>
    </message>
    <message>
        <source>it is still to be simulated again</source>
        <translation>czeka na ponowną symulację</translation>
    </message>
    <message>
        <source>Practice, not verified: it is not the exam that was open (%1)</source>
        <translation>Ćwiczenie, niezweryfikowane: to nie jest egzamin, który był otwarty (%1)</translation>
    </message>
    <message>
        <source>Practice, not verified: the time that it says cannot be right (%1)</source>
        <translation>Ćwiczenie, niezweryfikowane: podany czas nie może być prawdziwy (%1)</translation>
    </message>
    <message>
        <source>Practice, not verified: the exam asked for another version than %1</source>
        <translation>Ćwiczenie, niezweryfikowane: egzamin wymagał innej wersji niż %1</translation>
    </message>
</context>
<context>
    <name>TakeBackDialog</name>
    <message>
        <source>Writing the audit</source>
        <translation>Zapis w dzienniku</translation>
    </message>
    <message>
        <source>For the coordinator</source>
        <translation>Dla koordynatora</translation>
    </message>
    <message>
        <source>The screen belongs to a participant. %1 takes it back with the password or the PIN.</source>
        <translation>Ekran należy do uczestnika. %1 odbiera go hasłem lub kodem PIN.</translation>
    </message>
    <message>
        <source>The screen belongs to a participant. %1 takes it back with the password.</source>
        <translation>Ekran należy do uczestnika. %1 odbiera go hasłem.</translation>
    </message>
    <message>
        <source>Password of %1</source>
        <translation>Hasło: %1</translation>
    </message>
    <message>
        <source>Stay here</source>
        <translation>Zostań tutaj</translation>
    </message>
    <message>
        <source>Take the screen back</source>
        <translation>Odbierz ekran</translation>
    </message>
    <message>
        <source>Type your password.</source>
        <translation>Proszę wpisać hasło.</translation>
    </message>
    <message>
        <source>Too many wrong passwords. Try again in %1 s.</source>
        <translation>Za dużo błędnych haseł. Proszę spróbować za %1 s.</translation>
    </message>
    <message>
        <source>This account is deactivated.</source>
        <translation>To konto jest wyłączone.</translation>
    </message>
    <message>
        <source>That is wrong. The screen stays with the participant.</source>
        <translation>To nie to. Ekran zostaje u uczestnika.</translation>
    </message>
</context>
<context>
    <name>placode::ui::ProceduresCard</name>
    <message>
        <source>Reading the procedures</source>
        <translation>Odczyt zabiegów</translation>
    </message>
    <message>
        <source>Procedures of %1</source>
        <translation>Zabiegi: %1</translation>
    </message>
    <message>
        <source>%1 has not worked at the simulator yet.</source>
        <translation>%1: jeszcze bez pracy przy symulatorze.</translation>
    </message>
    <message>
        <source>done again: %1 (%2)</source>
        <translation>powtórzono: %1 (%2)</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>liczy się</translation>
    </message>
    <message>
        <source>does not count yet: %1</source>
        <translation>jeszcze się nie liczy: %1</translation>
    </message>
    <message>
        <source>does not count: %1</source>
        <translation>nie liczy się: %1</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Krok</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Kiedy</translation>
    </message>
    <message>
        <source>Lasted</source>
        <translation>Trwało</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Urządzenie</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stan</translation>
    </message>
    <message>
        <source>Procedures</source>
        <translation>Zabiegi</translation>
    </message>
    <message>
        <source>, visit %1</source>
        <translation>, wizyta %1</translation>
    </message>
    <message>
        <source>Why it went wrong, e.g. the pedal was unplugged</source>
        <translation>Co poszło źle, np. pedał był odłączony</translation>
    </message>
    <message>
        <source>Note on the procedure</source>
        <translation>Uwaga do zabiegu</translation>
    </message>
    <message>
        <source>Repeat this procedure …</source>
        <translation>Powtórz ten zabieg …</translation>
    </message>
    <message>
        <source>Add the note</source>
        <translation>Dodaj uwagę</translation>
    </message>
    <message>
        <source>Open the result</source>
        <translation>Otwórz wynik</translation>
    </message>
    <message>
        <source>A repeat needs a reason.</source>
        <translation>Powtórzenie wymaga powodu.</translation>
    </message>
    <message>
        <source>Write what went wrong; it stands in every export and report.</source>
        <translation>Proszę napisać, co poszło źle; powód stoi w każdym eksporcie i raporcie.</translation>
    </message>
    <message>
        <source>Repeat %1?</source>
        <translation>Powtórzyć: %1?</translation>
    </message>
    <message>
        <source>What %1 did is kept and marked with the reason; it counts no more. The participant does this step again.</source>
        <translation>To, co zrobił(a) %1, jest zachowane i oznaczone powodem; już się nie liczy. Uczestnik wykonuje ten krok jeszcze raz.</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Powtórz</translation>
    </message>
    <message>
        <source>Having the procedure done again</source>
        <translation>Zarządzenie powtórzenia zabiegu</translation>
    </message>
    <message>
        <source>Adding the note</source>
        <translation>Dodawanie uwagi</translation>
    </message>
    <message>
        <source>Looking for deviations</source>
        <translation>Szukanie odstępstw</translation>
    </message>
    <message>
        <source>Deviations from the protocol</source>
        <translation>Odstępstwa od protokołu</translation>
    </message>
    <message>
        <source>There are none.</source>
        <translation>Nie ma żadnych.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Rodzaj</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Co się stało</translation>
    </message>
    <message>
        <source>kept, but no analysis uses it: nothing was done</source>
        <translation>zachowane, ale żadna analiza tego nie używa: nic nie zrobiono</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>The store is not where it was.</source>
        <translation>Bazy nie ma tam, gdzie była.</translation>
    </message>
    <message>
        <source>Restore a backup, or show where the store is now.</source>
        <translation>Przywróć kopię zapasową albo wskaż, gdzie baza jest teraz.</translation>
    </message>
    <message>
        <source>The data that are there do not allow it.</source>
        <translation>Dane, które już są, na to nie pozwalają.</translation>
    </message>
    <message>
        <source>Nothing was changed. Try again; if it happens again, the details tell an administrator where to look.</source>
        <translation>Nic nie zostało zmienione. Spróbuj ponownie; jeśli się powtórzy, szczegóły powiedzą administratorowi, gdzie szukać.</translation>
    </message>
    <message>
        <source>The disk is full: make room, then try again.</source>
        <translation>Dysk jest pełny: zwolnij miejsce i spróbuj ponownie.</translation>
    </message>
    <message>
        <source>You may not write there: choose another folder, or ask an administrator.</source>
        <translation>Nie wolno tam zapisywać: wybierz inny folder albo zapytaj administratora.</translation>
    </message>
    <message>
        <source>The file or folder is not there any more: choose another one.</source>
        <translation>Tego pliku lub folderu już nie ma: wybierz inny.</translation>
    </message>
    <message>
        <source>The store is locked by another program.</source>
        <translation>Baza jest zablokowana przez inny program.</translation>
    </message>
    <message>
        <source>Close the other program, or wait and try again.</source>
        <translation>Zamknij ten program albo poczekaj i spróbuj ponownie.</translation>
    </message>
    <message>
        <source>A file is damaged and was left as it is.</source>
        <translation>Plik jest uszkodzony i pozostał bez zmian.</translation>
    </message>
    <message>
        <source>Restore a backup; nothing has been overwritten.</source>
        <translation>Przywróć kopię zapasową; nic nie zostało nadpisane.</translation>
    </message>
    <message>
        <source>This file was written by a newer Placode.</source>
        <translation>Ten plik zapisała nowsza wersja Placode.</translation>
    </message>
    <message>
        <source>Update Placode on this machine.</source>
        <translation>Zaktualizuj Placode na tym komputerze.</translation>
    </message>
    <message>
        <source>The store cannot be reached.</source>
        <translation>Nie ma dostępu do bazy.</translation>
    </message>
    <message>
        <source>Is its disk or its server there? Then try again; else tell an administrator.</source>
        <translation>Czy jej dysk lub serwer jest dostępny? Jeśli tak, spróbuj ponownie; jeśli nie, powiadom administratora.</translation>
    </message>
    <message>
        <source>This was refused.</source>
        <translation>Odmówiono.</translation>
    </message>
    <message>
        <source>This is taken, or was done already.</source>
        <translation>To jest zajęte albo już zrobione.</translation>
    </message>
    <message>
        <source>Look at the page again, then choose another name or number.</source>
        <translation>Obejrzyj stronę ponownie i wybierz inną nazwę lub numer.</translation>
    </message>
    <message>
        <source>This is not there any more.</source>
        <translation>Tego już nie ma.</translation>
    </message>
    <message>
        <source>Open the page again.</source>
        <translation>Otwórz stronę ponownie.</translation>
    </message>
    <message>
        <source>%1 did not work.</source>
        <translation>Nie udało się: %1.</translation>
    </message>
    <message>
        <source>One is still running: close its window first.</source>
        <translation>Jedna próba jeszcze trwa: najpierw zamknij jej okno.</translation>
    </message>
    <message>
        <source>A part of Placode is missing on this computer: install Placode again, or tell an administrator.</source>
        <translation>Na tym komputerze brakuje części Placode: zainstaluj Placode ponownie albo powiadom administratora.</translation>
    </message>
    <message>
        <source>Restart the computer and try again, or tell an administrator.</source>
        <translation>Uruchom komputer ponownie i spróbuj jeszcze raz albo powiadom administratora.</translation>
    </message>
    <message>
        <source>Switch the SpaceMouse on. Its driver, spacenavd, has to be installed and running.</source>
        <translation>Włącz SpaceMouse. Jej sterownik, spacenavd, musi być zainstalowany i uruchomiony.</translation>
    </message>
    <message>
        <source>Plug the arm in and switch it on. OpenHaptics and the Touch driver of 3D Systems have to be installed.</source>
        <translation>Podłącz ramię i włącz je. Muszą być zainstalowane OpenHaptics i sterownik Touch firmy 3D Systems.</translation>
    </message>
    <message>
        <source>Plug the Inverse3 in and switch it on. The Haply Inverse service has to be running.</source>
        <translation>Podłącz Inverse3 i włącz je. Usługa Haply Inverse musi działać.</translation>
    </message>
    <message>
        <source>Plug the Haptic Avatar in and switch it on. Your account has to belong to the group dialout.</source>
        <translation>Podłącz Haptic Avatar i włącz go. Twoje konto musi należeć do grupy dialout.</translation>
    </message>
    <message>
        <source>Plug the device in and switch it on. The libraries of the Force Dimension SDK have to be installed.</source>
        <translation>Podłącz urządzenie i włącz je. Muszą być zainstalowane biblioteki Force Dimension SDK.</translation>
    </message>
    <message>
        <source>Plug a gamepad in, or switch it on and pair it.</source>
        <translation>Podłącz pad albo włącz go i sparuj.</translation>
    </message>
    <message>
        <source>Plug the pedals in. Your account has to belong to the group input.</source>
        <translation>Podłącz pedały. Twoje konto musi należeć do grupy input.</translation>
    </message>
    <message>
        <source>Choose another device, or connect it and try again.</source>
        <translation>Wybierz inne urządzenie albo podłącz to i spróbuj ponownie.</translation>
    </message>
    <message>
        <source>It found no screen to open its window on: start Placode from the desktop of this computer.</source>
        <translation>Nie znalazł ekranu, na którym mógłby otworzyć okno: uruchom Placode z pulpitu tego komputera.</translation>
    </message>
    <message>
        <source>The graphics of this computer are too old or have no driver: install the graphics driver.</source>
        <translation>Grafika tego komputera jest za stara albo nie ma sterownika: zainstaluj sterownik graficzny.</translation>
    </message>
    <message>
        <source>There is not enough memory: close other programs, then try again.</source>
        <translation>Brakuje pamięci: zamknij inne programy i spróbuj ponownie.</translation>
    </message>
    <message>
        <source>A font is missing: install the package fonts-dejavu-core.</source>
        <translation>Brakuje czcionki: zainstaluj pakiet fonts-dejavu-core.</translation>
    </message>
    <message>
        <source>A definition file cannot be used.</source>
        <translation>Nie można użyć pliku definicji.</translation>
    </message>
    <message>
        <source>Correct the file at the place named, then try again.</source>
        <translation>Popraw plik we wskazanym miejscu i spróbuj ponownie.</translation>
    </message>
    <message>
        <source>The simulator could not be started.</source>
        <translation>Nie udało się uruchomić symulatora.</translation>
    </message>
    <message>
        <source>Choose another folder or file name, then try again.</source>
        <translation>Wybierz inny folder lub inną nazwę pliku i spróbuj ponownie.</translation>
    </message>
    <message>
        <source>The device cannot be used.</source>
        <translation>Nie można użyć urządzenia.</translation>
    </message>
    <message>
        <source>%1 cannot be used here.</source>
        <translation>Tutaj nie można użyć: %1.</translation>
    </message>
    <message>
        <source>The attempt could not be started.</source>
        <translation>Nie udało się rozpocząć próby.</translation>
    </message>
    <message>
        <source>The replay ended with a problem.</source>
        <translation>Odtwarzanie zakończyło się błędem.</translation>
    </message>
    <message>
        <source>The recording and its score are untouched.</source>
        <translation>Nagranie i jego wynik pozostają nienaruszone.</translation>
    </message>
    <message>
        <source>Choose another device or try again.</source>
        <translation>Wybierz inne urządzenie albo spróbuj ponownie.</translation>
    </message>
    <message>
        <source>The simulator ended unexpectedly.</source>
        <translation>Symulator zakończył się nieoczekiwanie.</translation>
    </message>
    <message>
        <source>What was recorded is kept and can be saved as interrupted.</source>
        <translation>To, co nagrano, pozostaje i można to zapisać jako próbę przerwaną.</translation>
    </message>
    <message>
        <source>A part of the recording is damaged; what is whole can be saved.</source>
        <translation>Część nagrania jest uszkodzona; to, co całe, można zapisać.</translation>
    </message>
    <message>
        <source>The recording is damaged and cannot be scored.</source>
        <translation>Nagranie jest uszkodzone i nie można go ocenić.</translation>
    </message>
    <message>
        <source>The recording of attempt %1 is damaged.</source>
        <translation>Nagranie próby %1 jest uszkodzone.</translation>
    </message>
    <message>
        <source>Its score stays; it cannot be watched. A backup may hold it whole.</source>
        <translation>Wynik pozostaje; próby nie można obejrzeć. Kopia zapasowa może zawierać całe nagranie.</translation>
    </message>
    <message>
        <source>A computer that nobody has vouched for wrote into the store.</source>
        <translation>Do bazy pisał komputer, za który nikt nie ręczył.</translation>
    </message>
    <message>
        <source>If it is one of yours, an administrator vouches for it with `placodectl station trust`. If not, ask who had access.</source>
        <translation>Jeśli to wasz komputer, administrator ręczy za niego poleceniem `placodectl station trust`. Jeśli nie, zapytaj, kto miał dostęp.</translation>
    </message>
    <message>
        <source>The end of the audit list is missing.</source>
        <translation>Brakuje końca dziennika zdarzeń.</translation>
    </message>
    <message>
        <source>It was cut off, or an older copy was put in the store's place by hand. Compare with a backup.</source>
        <translation>Został odcięty albo ktoś ręcznie podłożył starszą kopię bazy. Porównaj z kopią zapasową.</translation>
    </message>
    <message>
        <source>Data was changed from outside: %1.</source>
        <translation>Dane zmieniono z zewnątrz: %1.</translation>
    </message>
    <message>
        <source>The store holds what Placode did not put there: %1.</source>
        <translation>Baza zawiera coś, czego nie umieścił w niej Placode: %1.</translation>
    </message>
    <message>
        <source>Ask who put it there and have it taken out: until then the store is neither backed up nor updated.</source>
        <translation>Ustal, kto to umieścił, i poproś o usunięcie: do tego czasu nie powstanie kopia zapasowa ani aktualizacja bazy.</translation>
    </message>
    <message>
        <source>The audit list was changed from outside, near entry %1.</source>
        <translation>Dziennik zdarzeń został zmieniony z zewnątrz, w pobliżu wpisu %1.</translation>
    </message>
    <message>
        <source>Ask who had access to the file or the server, and compare with a backup.</source>
        <translation>Zapytaj, kto miał dostęp do pliku lub serwera, i porównaj z kopią zapasową.</translation>
    </message>
    <message>
        <source>The file of the store is damaged.</source>
        <translation>Plik bazy jest uszkodzony.</translation>
    </message>
    <message>
        <source>Make a copy of it now, then restore the last backup that is sound.</source>
        <translation>Zrób teraz jego kopię, a potem przywróć ostatnią sprawną kopię zapasową.</translation>
    </message>
    <message>
        <source>The list of people cannot be used; nobody was added.</source>
        <translation>Nie można użyć listy osób; nikogo nie dodano.</translation>
    </message>
    <message>
        <source>Correct the line named below, then choose the file again.</source>
        <translation>Popraw wskazany poniżej wiersz, potem wybierz plik ponownie.</translation>
    </message>
</context>
<context>
    <name>Said</name>
    <message>
        <source>the station&apos;s key %1 is open to others (mode %2); `chmod 600` it, or move it away if somebody may have copied it: the computer then signs as a new station</source>
        <translation>klucz stanowiska %1 jest dostępny dla innych (prawa %2); ustaw `chmod 600` albo przenieś go gdzie indziej, jeśli ktoś mógł go skopiować: komputer podpisuje wtedy jako nowe stanowisko</translation>
    </message>
    <message>
        <source>the station&apos;s key %1 belongs to another account (number %2); run Placode as that one, or set PLACODE_STATION_KEY to a file of your own</source>
        <translation>klucz stanowiska %1 należy do innego konta (numer %2); uruchom Placode na tamtym koncie albo ustaw w PLACODE_STATION_KEY własny plik</translation>
    </message>
    <message>
        <source>perform an attempt</source>
        <translation>wykonać próby</translation>
    </message>
    <message>
        <source>see other people's attempts</source>
        <translation>oglądać prób innych osób</translation>
    </message>
    <message>
        <source>see other people's personal data</source>
        <translation>oglądać danych osobowych innych osób</translation>
    </message>
    <message>
        <source>manage accounts</source>
        <translation>zarządzać kontami</translation>
    </message>
    <message>
        <source>have a questionnaire answered</source>
        <translation>przeprowadzać kwestionariuszy</translation>
    </message>
    <message>
        <source>export the data of a study</source>
        <translation>eksportować danych badania</translation>
    </message>
    <message>
        <source>back up, restore or check the store</source>
        <translation>tworzyć kopii, przywracać ani sprawdzać bazy</translation>
    </message>
    <message>
        <source>see the audit trail</source>
        <translation>oglądać dziennika zdarzeń</translation>
    </message>
    <message>
        <source>publish courses</source>
        <translation>publikować kursów</translation>
    </message>
    <message>
        <source>assign courses to this person or group</source>
        <translation>przydzielać kursów tej osobie lub grupie</translation>
    </message>
    <message>
        <source>change groups</source>
        <translation>zmieniać grup</translation>
    </message>
    <message>
        <source>issue this person's certificate</source>
        <translation>wystawić certyfikatu tej osoby</translation>
    </message>
    <message>
        <source>review this person's attempts</source>
        <translation>oceniać prób tej osoby</translation>
    </message>
    <message>
        <source>set standards or rescore</source>
        <translation>ustalać standardów ani oceniać ponownie</translation>
    </message>
    <message>
        <source>export another person's data</source>
        <translation>eksportować danych innej osoby</translation>
    </message>
    <message>
        <source>ask for another person's erasure</source>
        <translation>prosić o usunięcie innej osoby</translation>
    </message>
    <message>
        <source>erase a person</source>
        <translation>usunąć osoby</translation>
    </message>
    <message>
        <source>use the store without signing in</source>
        <translation>korzystać z bazy bez zalogowania</translation>
    </message>
    <message>
        <source>set another person's password</source>
        <translation>zmieniać hasła innej osoby</translation>
    </message>
    <message>
        <source>choose another person's PIN</source>
        <translation>wybierać kodu PIN innej osoby</translation>
    </message>
    <message>
        <source>save another person's attempt</source>
        <translation>zapisywać próby innej osoby</translation>
    </message>
    <message>
        <source>remark on this person's attempts</source>
        <translation>pisać uwag do prób tej osoby</translation>
    </message>
    <message>
        <source>say what simulating an attempt again gave</source>
        <translation>zapisywać wyniku ponownej symulacji próby</translation>
    </message>
    <message>
        <source>act in another person's name</source>
        <translation>działać w imieniu innej osoby</translation>
    </message>
    <message>
        <source>everybody who has signed in</source>
        <translation>każda zalogowana osoba</translation>
    </message>
    <message>
        <source>the person or an administrator</source>
        <translation>ta osoba lub administrator</translation>
    </message>
    <message>
        <source>only the program itself</source>
        <translation>tylko sam program</translation>
    </message>
    <message>
        <source>everybody, in their own name</source>
        <translation>każdy, we własnym imieniu</translation>
    </message>
    <message>
        <source>an educator</source>
        <translation>instruktor</translation>
    </message>
    <message>
        <source>an educator or an administrator</source>
        <translation>instruktor lub administrator</translation>
    </message>
    <message>
        <source>an administrator</source>
        <translation>administrator</translation>
    </message>
    <message>
        <source>a coordinator</source>
        <translation>koordynator</translation>
    </message>
    <message>
        <source>an educator of the group</source>
        <translation>instruktor tej grupy</translation>
    </message>
    <message>
        <source>an educator of the group or an administrator</source>
        <translation>instruktor tej grupy lub administrator</translation>
    </message>
    <message>
        <source>the person, or an educator of the group,</source>
        <translation>ta osoba lub instruktor grupy</translation>
    </message>
    <message>
        <source>an educator of the group, not the person,</source>
        <translation>instruktor grupy, nie ta osoba</translation>
    </message>
    <message>
        <source>the person</source>
        <translation>ta osoba</translation>
    </message>
    <message>
        <source>an administrator, not the person,</source>
        <translation>administrator, nie ta osoba</translation>
    </message>
    <message>
        <source>you may not %1; %2 can</source>
        <translation>nie możesz %1; może to zrobić %2</translation>
    </message>
    <message>
        <source>there is an account already; sign in to it</source>
        <translation>jest już konto; zaloguj się na nie</translation>
    </message>
    <message>
        <source>on a server everybody has an account and a password</source>
        <translation>na serwerze każdy ma konto i hasło</translation>
    </message>
    <message>
        <source>there is no profile without a password here</source>
        <translation>nie ma tu profilu bez hasła</translation>
    </message>
    <message>
        <source>this store is one person's without a password; make an account of that profile first</source>
        <translation>ta baza należy do jednej osoby bez hasła; najpierw załóż konto dla tego profilu</translation>
    </message>
    <message>
        <source>its tables are missing or of an older version, and this log-in may not make any; their owner does, with `placodectl station role --apply`</source>
        <translation>brak jej tabel albo są ze starszej wersji, a ten login nie może ich tworzyć; robi to ich właściciel poleceniem `placodectl station role --apply`</translation>
    </message>
    <message>
        <source>people come from a learning platform without signing in to the server; use a log-in that is member of placode_service, on a computer that no trainee uses</source>
        <translation>z platformy edukacyjnej ludzie wchodzą bez logowania do serwera; użyj loginu, który należy do placode_service, na komputerze, z którego nie korzysta żaden uczący się</translation>
    </message>
    <message>
        <source>this log-in to the server can do more than a station should (%1); use one that is member of placode_station</source>
        <translation>ten login do serwera może więcej niż powinno stanowisko (%1); użyj loginu, który należy do placode_station</translation>
    </message>
    <message>
        <source>the rules that the server keeps by itself are missing or of another version; the owner of its tables runs `placodectl station role --apply`</source>
        <translation>brak reguł, których serwer pilnuje sam, albo są z innej wersji; właściciel tabel uruchamia `placodectl station role --apply`</translation>
    </message>
    <message>
        <source>you may not do this on the server; sign in again with an account that may; nothing was changed</source>
        <translation>serwer na to nie pozwala; zaloguj się ponownie na konto, które ma takie prawo; niczego nie zmieniono</translation>
    </message>
    <message>
        <source>the store was moved to %1; use that address, or bring it back with `%2`</source>
        <translation>bazę przeniesiono do %1; użyj tego adresu albo przenieś ją z powrotem poleceniem `%2`</translation>
    </message>
    <message>
        <source>the store was moved to %1; use that address, or bring it back with `%2`; nothing was changed</source>
        <translation>bazę przeniesiono do %1; użyj tego adresu albo przenieś ją z powrotem poleceniem `%2`; niczego nie zmieniono</translation>
    </message>
    <message>
        <source>a store is being moved here from %1, and that is not finished; go on with `%2`</source>
        <translation>baza z %1 jest właśnie tu przenoszona i nie jest to zakończone; dokończ poleceniem `%2`</translation>
    </message>
    <message>
        <source>it holds %1, which Placode did not make and which may be there to do harm; nothing was changed; use another copy of the store, or have whoever put it there take it out</source>
        <translation>plik zawiera obiekt spoza Placode, być może podłożony w złym celu: %1; niczego nie zmieniono; użyj innej kopii bazy albo poproś o jego usunięcie osobę, która go tam umieściła</translation>
    </message>
    <message>
        <source>the proctor &quot;%1&quot; has no account here</source>
        <translation>osoba nadzorująca &quot;%1&quot; nie ma tu konta</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no active educator or administrator and cannot be the proctor</source>
        <translation>&quot;%1&quot; nie jest aktywnym instruktorem ani administratorem i nie może nadzorować</translation>
    </message>
    <message>
        <source>nobody can be their own proctor</source>
        <translation>nikt nie może nadzorować samego siebie</translation>
    </message>
    <message>
        <source>the recording is larger than 1 GiB</source>
        <translation>nagranie jest większe niż 1 GiB</translation>
    </message>
    <message>
        <source>attempt %1 belongs to %2 of the study &quot;%3&quot;</source>
        <translation>próba %1 należy do %2 w badaniu „%3”</translation>
    </message>
    <message>
        <source>the login is taken; choose another one</source>
        <translation>login jest zajęty; wybierz inny</translation>
    </message>
    <message>
        <source>the login is empty</source>
        <translation>login jest pusty</translation>
    </message>
    <message>
        <source>the login reads as the number of an account; put a letter before it</source>
        <translation>login wygląda jak numer konta; poprzedź go literą</translation>
    </message>
    <message>
        <source>the login holds letters that are not seen; type it again</source>
        <translation>login zawiera niewidoczne znaki; wpisz go ponownie</translation>
    </message>
    <message>
        <source>the name is empty</source>
        <translation>nazwa jest pusta</translation>
    </message>
    <message>
        <source>the name holds letters that are not seen, such as the end of a line; type it again</source>
        <translation>nazwa zawiera niewidoczne znaki, na przykład koniec wiersza; wpisz ją ponownie</translation>
    </message>
    <message>
        <source>the name is longer than %1 characters</source>
        <translation>nazwa jest dłuższa niż %1 znaków</translation>
    </message>
    <message>
        <source>the login is longer than %1 characters</source>
        <translation>login jest dłuższy niż %1 znaków</translation>
    </message>
    <message>
        <source>the user has no role</source>
        <translation>ta osoba nie ma żadnej roli</translation>
    </message>
    <message>
        <source>the password is longer than %1 characters</source>
        <translation>hasło ma więcej niż %1 znaków</translation>
    </message>
    <message>
        <source>the password is the login; choose another one</source>
        <translation>hasło jest takie samo jak login; wybierz inne</translation>
    </message>
    <message>
        <source>a PIN has four to twelve digits</source>
        <translation>PIN ma od czterech do dwunastu cyfr</translation>
    </message>
    <message>
        <source>all digits the same, or in a row, is the first that somebody tries</source>
        <translation>same jednakowe cyfry albo cyfry po kolei to pierwsze, czego ktoś spróbuje</translation>
    </message>
    <message>
        <source>"%1" is the last active administrator; make another one first</source>
        <translation>"%1" to ostatni aktywny administrator; najpierw ustanów innego</translation>
    </message>
    <message>
        <source>the code is wrong or was used; ask for another one</source>
        <translation>kod jest błędny lub już użyty; poproś o inny</translation>
    </message>
    <message>
        <source>the invitation ended on %1; ask for another one</source>
        <translation>zaproszenie wygasło %1; poproś o inne</translation>
    </message>
    <message>
        <source>the invitation has no role</source>
        <translation>zaproszenie nie zawiera roli</translation>
    </message>
    <message>
        <source>found the date "%1"; an invitation needs a last day, such as %2</source>
        <translation>podano datę "%1"; zaproszenie wymaga ostatniego dnia, na przykład %2</translation>
    </message>
    <message>
        <source>erasure was asked for already</source>
        <translation>o usunięcie już poproszono</translation>
    </message>
    <message>
        <source>there is a group of this name; choose another one</source>
        <translation>grupa o tej nazwie już istnieje; wybierz inną</translation>
    </message>
    <message>
        <source>found the date "%1"; expected a day such as %2</source>
        <translation>podano datę "%1"; oczekiwano dnia, na przykład %2</translation>
    </message>
    <message>
        <source>the course is due before it begins</source>
        <translation>termin kursu wypada przed jego początkiem</translation>
    </message>
    <message>
        <source>a course is assigned to a person or to a group</source>
        <translation>kurs przydziela się osobie albo grupie</translation>
    </message>
    <message>
        <source>version %1 is not published; publish it first</source>
        <translation>wersja %1 nie jest opublikowana; najpierw ją opublikuj</translation>
    </message>
    <message>
        <source>it is assigned already (assignment %1); end that one first</source>
        <translation>kurs jest już przydzielony (przydział %1); najpierw zakończ tamten</translation>
    </message>
    <message>
        <source>it ended at %1</source>
        <translation>zakończono to %1</translation>
    </message>
    <message>
        <source>found %1; expected 1 to 1000</source>
        <translation>podano %1; oczekiwano od 1 do 1000</translation>
    </message>
    <message>
        <source>a grant needs a reason</source>
        <translation>dodatkowe próby wymagają uzasadnienia</translation>
    </message>
    <message>
        <source>an entry is set aside with a reason</source>
        <translation>wpis odkłada się na bok tylko z uzasadnieniem</translation>
    </message>
    <message>
        <source>the course has no such exam stage</source>
        <translation>kurs nie ma takiego etapu egzaminacyjnego</translation>
    </message>
    <message>
        <source>the course is not assigned to this person</source>
        <translation>kurs nie jest przydzielony tej osobie</translation>
    </message>
    <message>
        <source>locked; to be mastered first: %1</source>
        <translation>zamknięte; najpierw trzeba zaliczyć: %1</translation>
    </message>
    <message>
        <source>all attempts are used</source>
        <translation>wszystkie próby zostały wykorzystane</translation>
    </message>
    <message>
        <source>the proctor's name is missing</source>
        <translation>brakuje nazwiska osoby nadzorującej</translation>
    </message>
    <message>
        <source>the device has no haptic certificate</source>
        <translation>urządzenie nie ma certyfikatu haptycznego</translation>
    </message>
    <message>
        <source>not mastered yet. %1</source>
        <translation>jeszcze niezaliczone. %1</translation>
    </message>
    <message>
        <source>%1 is published with another text, which is never changed; give your text the next version</source>
        <translation>%1 jest opublikowane z innym tekstem, którego się nie zmienia; nadaj swojemu tekstowi następną wersję</translation>
    </message>
    <message>
        <source>%1 is a task of Placode itself, which has version %2 of it; give your text an id of its own</source>
        <translation>%1 to zadanie samego Placode, który ma je w wersji %2; nadaj swojemu tekstowi własny identyfikator</translation>
    </message>
    <message>
        <source>version %1 is published already; give your text a higher version</source>
        <translation>wersja %1 jest już opublikowana; nadaj swojemu tekstowi wyższą wersję</translation>
    </message>
    <message>
        <source>an amendment needs a reason</source>
        <translation>zmiana wymaga uzasadnienia</translation>
    </message>
    <message>
        <source>participants are allocated to the arms of version %1; keep their names and order, and add others only behind them</source>
        <translation>uczestnicy są przydzieleni do grup wersji %1; zachowaj ich nazwy i kolejność, a inne dodawaj tylko za nimi</translation>
    </message>
    <message>
        <source>only questionnaires, studies, courses, tasks, rubrics, standards and seals of consents are published</source>
        <translation>publikuje się tylko kwestionariusze, badania, kursy, zadania, kryteria, standardy i pieczęcie zgód</translation>
    </message>
    <message>
        <source>rubric %1 version %2 is known with another text; give the rubric the next version</source>
        <translation>kryteria %1 w wersji %2 są znane z innym tekstem; nadaj im następną wersję</translation>
    </message>
    <message>
        <source>the study "%1" has no participant "%2"; check the code</source>
        <translation>badanie "%1" nie ma uczestnika "%2"; sprawdź kod</translation>
    </message>
    <message>
        <source>there is no such participant; check the code</source>
        <translation>nie ma takiego uczestnika; sprawdź kod</translation>
    </message>
    <message>
        <source>%1 has withdrawn (%2); nothing more is recorded</source>
        <translation>%1 wycofał się (%2); nic więcej nie jest zapisywane</translation>
    </message>
    <message>
        <source>%1 has not consented; record the step "%2" first</source>
        <translation>%1 nie wyraził zgody; najpierw zapisz krok "%2"</translation>
    </message>
    <message>
        <source>the participant has withdrawn already (%1)</source>
        <translation>uczestnik już się wycofał (%1)</translation>
    </message>
    <message>
        <source>a withdrawal needs a reason; "not given" is one</source>
        <translation>wycofanie wymaga powodu; "nie podano" też nim jest</translation>
    </message>
    <message>
        <source>the step has no id</source>
        <translation>krok nie ma identyfikatora</translation>
    </message>
    <message>
        <source>the study has no id</source>
        <translation>badanie nie ma identyfikatora</translation>
    </message>
    <message>
        <source>the study has no published protocol that asks for one</source>
        <translation>badanie nie ma opublikowanego protokołu, który wymaga zgody</translation>
    </message>
    <message>
        <source>the statement "%1" is required and was not agreed to</source>
        <translation>oświadczenie "%1" jest wymagane i nie zostało zaakceptowane</translation>
    </message>
    <message>
        <source>the record of %1 is locked; unlock it with a reason first, which cancels its signature</source>
        <translation>rekord %1 jest zablokowany; najpierw odblokuj go z uzasadnieniem, co unieważni podpis</translation>
    </message>
    <message>
        <source>it is locked already</source>
        <translation>już zablokowany</translation>
    </message>
    <message>
        <source>it is not locked</source>
        <translation>nie jest zablokowany</translation>
    </message>
    <message>
        <source>it is signed already, by %1</source>
        <translation>już podpisany przez: %1</translation>
    </message>
    <message>
        <source>a signature needs its meaning, such as "%1"</source>
        <translation>podpis wymaga znaczenia, na przykład "%1"</translation>
    </message>
    <message>
        <source>too many wrong passwords; try again in %1 s</source>
        <translation>za dużo błędnych haseł; spróbuj ponownie za %1 s</translation>
    </message>
    <message>
        <source>login or password is wrong; nothing was signed</source>
        <translation>login lub hasło jest błędne; nic nie podpisano</translation>
    </message>
    <message>
        <source>lock the record first: what is signed must not change</source>
        <translation>najpierw zablokuj rekord: to, co podpisane, nie może się zmieniać</translation>
    </message>
    <message>
        <source>unlocking needs a reason</source>
        <translation>odblokowanie wymaga uzasadnienia</translation>
    </message>
    <message>
        <source>nothing was signed</source>
        <translation>nic nie podpisano</translation>
    </message>
    <message>
        <source>the consent was signed at %1</source>
        <translation>zgodę podpisano %1</translation>
    </message>
    <message>
        <source>the questionnaire %1 is not published, so that nothing says which answers are possible</source>
        <translation>kwestionariusz %1 nie jest opublikowany, więc nie wiadomo, jakie odpowiedzi są możliwe</translation>
    </message>
    <message>
        <source>a correction needs a reason</source>
        <translation>poprawka wymaga uzasadnienia</translation>
    </message>
    <message>
        <source>nothing would change</source>
        <translation>nic by się nie zmieniło</translation>
    </message>
    <message>
        <source>these answers have no second entry</source>
        <translation>te odpowiedzi nie mają drugiego wpisu</translation>
    </message>
    <message>
        <source>these answers have a second entry, by %1</source>
        <translation>te odpowiedzi mają już drugi wpis, wpisał(a): %1</translation>
    </message>
    <message>
        <source>the passphrase is too short; expected at least %1 characters, four words are good</source>
        <translation>hasło klucza jest za krótkie; potrzeba co najmniej %1 znaków, dobre są cztery słowa</translation>
    </message>
    <message>
        <source>the passphrase is wrong, or the file was changed</source>
        <translation>hasło do pliku jest błędne albo plik został zmieniony</translation>
    </message>
    <message>
        <source>"%1" is no participant's code</source>
        <translation>"%1" nie jest kodem uczestnika</translation>
    </message>
    <message>
        <source>the name is missing</source>
        <translation>brakuje nazwiska</translation>
    </message>
    <message>
        <source>is there already; open it, or choose another place</source>
        <translation>plik już istnieje; otwórz go albo wybierz inne miejsce</translation>
    </message>
    <message>
        <source>there is no such file; create the key first</source>
        <translation>nie ma takiego pliku; najpierw utwórz klucz</translation>
    </message>
    <message>
        <source>the time is not within the attempt of %1 s</source>
        <translation>ta chwila nie mieści się w próbie trwającej %1 s</translation>
    </message>
    <message>
        <source>a remark needs a text or a time</source>
        <translation>uwaga wymaga tekstu albo chwili</translation>
    </message>
    <message>
        <source>nobody rates an attempt of their own</source>
        <translation>nikt nie ocenia własnej próby</translation>
    </message>
    <message>
        <source>this rater has rated the attempt already</source>
        <translation>ta osoba już oceniła tę próbę</translation>
    </message>
    <message>
        <source>the centre has no name yet; give it with the first norm pack</source>
        <translation>ośrodek nie ma jeszcze nazwy; podaj ją przy pierwszym pakiecie norm</translation>
    </message>
    <message>
        <source>the level &quot;%1&quot; has %2 persons with attempts; at least %3 are needed, because bands of fewer tell about persons</source>
        <translation>na poziomie „%1” osób z próbami jest %2; potrzeba co najmniej %3, bo pasmo mniejszej liczby mówi o osobach</translation>
    </message>
    <message>
        <source>%1 of %2 attempts were never simulated again; let `placodectl verify --all` do that first</source>
        <translation>prób, których nie zasymulowano ponownie: %1 z %2; najpierw niech zrobi to `placodectl verify --all`</translation>
    </message>
    <message>
        <source>its signature is wrong: the pack was changed after it was signed</source>
        <translation>podpis jest błędny: pakiet zmieniono po podpisaniu</translation>
    </message>
    <message>
        <source>its centre "%1" with the key %2 is not trusted here</source>
        <translation>ośrodek "%1" z kluczem %2 nie jest tu zaufany</translation>
    </message>
    <message>
        <source>it says to be of "%1", but its key %2 is trusted here as that of "%3"</source>
        <translation>pakiet podaje, że pochodzi z ośrodka "%1", ale jego klucz %2 jest tu zaufany jako klucz ośrodka "%3"</translation>
    </message>
    <message>
        <source>%1 is not installed on this computer; install the package postgresql-client</source>
        <translation>na tym komputerze nie ma programu %1; zainstaluj pakiet postgresql-client</translation>
    </message>
    <message>
        <source>a backup of a server needs the log-in of the tables' owner, %1; a station sees only what people may see</source>
        <translation>kopia serwera wymaga loginu właściciela tabel, %1; stanowisko widzi tylko to, co wolno widzieć ludziom</translation>
    </message>
    <message>
        <source>%1 exists and is not overwritten; give another name</source>
        <translation>%1 już istnieje i nie zostanie nadpisane; podaj inną nazwę</translation>
    </message>
    <message>
        <source>only %1 MB are free there, and the copy needs %2 MB; make room, or give another place</source>
        <translation>jest tam tylko %1 MB wolnego miejsca, a kopia potrzebuje %2 MB; zwolnij miejsce albo wskaż inne</translation>
    </message>
    <message>
        <source>the attempt has no recording</source>
        <translation>próba nie ma nagrania</translation>
    </message>
    <message>
        <source>the file is empty: the attempt never began; it can be removed</source>
        <translation>plik jest pusty: próba się nie rozpoczęła; można go usunąć</translation>
    </message>
    <message>
        <source>a repeat needs a reason</source>
        <translation>powtórzenie wymaga uzasadnienia</translation>
    </message>
    <message>
        <source>there is no attempt of this step that counts; only a procedure that was done is done again</source>
        <translation>nie ma próby tego kroku, która się liczy; powtarza się tylko zabieg, który został wykonany</translation>
    </message>
    <message>
        <source>the note is empty</source>
        <translation>notatka jest pusta</translation>
    </message>
    <message>
        <source>no device is named</source>
        <translation>nie podano urządzenia</translation>
    </message>
    <message>
        <source>the length of the password is %1; it needs at least %2</source>
        <translation>długość hasła to %1; potrzeba co najmniej %2</translation>
    </message>
    <message>
        <source>the passphrase of the centre&apos;s key is wrong; try again</source>
        <translation>hasło klucza ośrodka jest błędne; spróbuj ponownie</translation>
    </message>
    <message>
        <source>on a server the centre&apos;s key is sealed and changed with the log-in of the tables&apos; owner; let an administrator run `placodectl norms key seal` with it</source>
        <translation>na serwerze klucz ośrodka zabezpiecza i zmienia się loginem właściciela tabel; niech administrator uruchomi nim `placodectl norms key seal`</translation>
    </message>
    <message>
        <source>the attempts are of different versions of the task or of its rubric; choose people whose attempts are of one version</source>
        <translation>próby pochodzą z różnych wersji zadania lub jego kryteriów oceny; wybierz osoby, których próby są z jednej wersji</translation>
    </message>
    <message>
        <source>only an embedded store is restored from a file; use pg_restore on the server</source>
        <translation>z pliku przywraca się tylko bazę, która sama jest plikiem; na serwerze użyj pg_restore</translation>
    </message>
    <message>
        <source>%1 version %2</source>
        <translation>%1 w wersji %2</translation>
    </message>
    <message>
        <source>the recording is damaged</source>
        <translation>nagranie jest uszkodzone</translation>
    </message>
    <message>
        <source>its task is not the published one</source>
        <translation>jego zadanie nie jest opublikowanym</translation>
    </message>
    <message>
        <source>this computer (%1) is not one that the store trusts; at one that is, an administrator trusts it: `placodectl station trust`</source>
        <translation>ten komputer (%1) nie należy do tych, którym baza ufa; na zaufanym administrator nadaje mu zaufanie: `placodectl station trust`</translation>
    </message>
    <message>
        <source>the store holds something else than the recording (%1)</source>
        <translation>baza zawiera co innego niż nagranie (%1)</translation>
    </message>
    <message>
        <source>no computer of this store signed its recording</source>
        <translation>jej nagrania nie podpisał żaden komputer tej bazy</translation>
    </message>
    <message>
        <source>its recording is that of attempt %1</source>
        <translation>jej nagranie jest nagraniem próby %1</translation>
    </message>
    <message>
        <source>the haptic certificate of the recording cannot be read</source>
        <translation>nie można odczytać certyfikatu haptycznego nagrania</translation>
    </message>
    <message>
        <source>%1; nothing was changed</source>
        <translation>%1; niczego nie zmieniono</translation>
    </message>
    <message>
        <source>%1 device faults (at most %2)</source>
        <translation>usterki urządzenia: %1 (najwyżej %2)</translation>
    </message>
    <message>
        <source>%1 device faults (at most %2); the last error was %3</source>
        <translation>usterki urządzenia: %1 (najwyżej %2); ostatni błąd: %3</translation>
    </message>
    <message>
        <source>the haptic loop ran for %1 s only</source>
        <translation>pętla haptyczna działała tylko %1 s</translation>
    </message>
    <message>
        <source>late in %1 of the ticks (at most %2)</source>
        <translation>spóźnienia w %1 cykli (najwyżej %2)</translation>
    </message>
    <message>
        <source>%1 drop-outs of more than 5 ms (at most %2 a minute)</source>
        <translation>przerwy dłuższe niż 5 ms: %1 (najwyżej %2 na minutę)</translation>
    </message>
    <message>
        <source>tool state older than 10 ms in %1 of the ticks (at most %2)</source>
        <translation>stan narzędzia starszy niż 10 ms w %1 cykli (najwyżej %2)</translation>
    </message>
    <message>
        <source>force at its ceiling in %1 of the ticks (at most %2)</source>
        <translation>siła na górnej granicy w %1 cykli (najwyżej %2)</translation>
    </message>
    <message>
        <source>force lowered by motor heat in %1 of the ticks (at most %2)</source>
        <translation>siła obniżona z powodu nagrzania silników w %1 cykli (najwyżej %2)</translation>
    </message>
    <message>
        <source>the haptic port gave %1 mJ more than it took (at most %2 mJ)</source>
        <translation>port haptyczny oddał o %1 mJ więcej, niż pobrał (najwyżej %2 mJ)</translation>
    </message>
    <message>
        <source>frame_s is %1, expected 0.00001 to 0.1</source>
        <translation>frame_s wynosi %1, oczekiwano od 0.00001 do 0.1</translation>
    </message>
    <message>
        <source>sample_s is %1, expected 0.001 to 1</source>
        <translation>sample_s wynosi %1, oczekiwano od 0.001 do 1</translation>
    </message>
    <message>
        <source>it has %1 tools, expected 1 to %2</source>
        <translation>liczba narzędzi: %1, oczekiwano od 1 do %2</translation>
    </message>
    <message>
        <source>duration_s is %1, expected 0 to %2</source>
        <translation>duration_s wynosi %1, oczekiwano od 0 do %2</translation>
    </message>
    <message>
        <source>%1 entries are lost, of %2 inputs</source>
        <translation>utracone wpisy: %1, przy liczbie wejść %2</translation>
    </message>
    <message>
        <source>its inputs last %1 s, its end says %2 s</source>
        <translation>jego wejścia trwają %1 s, a zakończenie podaje %2 s</translation>
    </message>
    <message>
        <source>stage is %1, expected 0 to %2</source>
        <translation>stage wynosi %1, oczekiwano od 0 do %2</translation>
    </message>
    <message>
        <source>%1 inputs were given, its head says %2</source>
        <translation>gotowe wejścia: %1, a nagłówek podaje %2</translation>
    </message>
    <message>
        <source>%1 inputs were given, more than %2 s</source>
        <translation>gotowe wejścia: %1, dłużej niż %2 s</translation>
    </message>
    <message>
        <source>%1 has %2 points, expected 3 or more</source>
        <translation>%1: liczba punktów %2, oczekiwano co najmniej 3</translation>
    </message>
    <message>
        <source>%1 has a point that lies nowhere</source>
        <translation>%1 ma punkt, który nie leży nigdzie</translation>
    </message>
    <message>
        <source>target_depth_m is %1</source>
        <translation>target_depth_m wynosi %1</translation>
    </message>
    <message>
        <source>placode_volume_m3 is %1</source>
        <translation>placode_volume_m3 wynosi %1</translation>
    </message>
    <message>
        <source>the input of frame %1 follows that of frame %2</source>
        <translation>wejście klatki %1 następuje po wejściu klatki %2</translation>
    </message>
    <message>
        <source>the input of frame %1 is of %2 tools, expected %3</source>
        <translation>wejście klatki %1 ma narzędzi: %2, oczekiwano %3</translation>
    </message>
    <message>
        <source>the input of frame %1 has %2 substeps</source>
        <translation>wejście klatki %1 ma podkroków: %2</translation>
    </message>
    <message>
        <source>the input of frame %1 has a hand that lies nowhere</source>
        <translation>wejście klatki %1 ma dłoń, która nie leży nigdzie</translation>
    </message>
    <message>
        <source>sample %1 has a tip that lies nowhere</source>
        <translation>próbka %1 ma końcówkę, która nie leży nigdzie</translation>
    </message>
    <message>
        <source>sample %1 has a tool that points nowhere</source>
        <translation>próbka %1 ma narzędzie, które nie wskazuje żadnego kierunku</translation>
    </message>
    <message>
        <source>sample %1 has a force that is no number</source>
        <translation>próbka %1 ma siłę, która nie jest liczbą</translation>
    </message>
    <message>
        <source>sample %1 has a jaw or a power that is no number</source>
        <translation>próbka %1 ma szczęki lub moc, które nie są liczbą</translation>
    </message>
    <message>
        <source>sample %1 has a distance that is no number</source>
        <translation>próbka %1 ma odległość, która nie jest liczbą</translation>
    </message>
    <message>
        <source>sample %1 has a temperature, dose or volume that cannot be</source>
        <translation>próbka %1 ma niemożliwą temperaturę, dawkę lub objętość</translation>
    </message>
    <message>
        <source>sample %1 has a share that was cut beyond 0 to 1</source>
        <translation>próbka %1 ma udział przecięcia spoza zakresu od 0 do 1</translation>
    </message>
    <message>
        <source>sample %1 is at %2 s, the one before it at %3 s</source>
        <translation>próbka %1 jest w chwili %2 s, poprzednia w chwili %3 s</translation>
    </message>
    <message>
        <source>its samples go on to %1 s, its end says %2 s</source>
        <translation>jego próbki sięgają %1 s, a zakończenie podaje %2 s</translation>
    </message>
    <message>
        <source>%1 samples for %2 s, expected %3</source>
        <translation>liczba próbek: %1 na %2 s, oczekiwano %3</translation>
    </message>
    <message>
        <source>event %1 is at %2 s of %3 s</source>
        <translation>zdarzenie %1 jest w chwili %2 s z %3 s</translation>
    </message>
    <message>
        <source>event %1 has a value that is no number</source>
        <translation>zdarzenie %1 ma wartość, która nie jest liczbą</translation>
    </message>
    <message>
        <source>final_hash is not the hash of its last state</source>
        <translation>final_hash nie jest skrótem jego ostatniego stanu</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>„%1” nie jest liczbą</translation>
    </message>
    <message>
        <source>%1 is not a whole number</source>
        <translation>%1 nie jest liczbą całkowitą</translation>
    </message>
    <message>
        <source>%1 is below %2</source>
        <translation>%1 to mniej niż %2</translation>
    </message>
    <message>
        <source>%1 is above %2</source>
        <translation>%1 to więcej niż %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a list of choices such as &quot;0;2&quot;</source>
        <translation>„%1” nie jest listą wyborów taką jak „0;2”</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names its choices twice or not in order</source>
        <translation>„%1” podaje wybory dwukrotnie lub nie po kolei</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a date such as 2026-11-21</source>
        <translation>„%1” nie jest datą taką jak 2026-11-21</translation>
    </message>
    <message>
        <source>&quot;NA&quot; is not offered here</source>
        <translation>odpowiedź „NA” nie jest tu możliwa</translation>
    </message>
    <message>
        <source>item %1 is answered, but hidden by the answer to item %2</source>
        <translation>na pytanie %1 podano odpowiedź, ale ukrywa je odpowiedź na pytanie %2</translation>
    </message>
    <message>
        <source>item %1 needs an answer</source>
        <translation>pytanie %1 wymaga odpowiedzi</translation>
    </message>
    <message>
        <source>item %1: %2</source>
        <translation>pytanie %1: %2</translation>
    </message>
    <message>
        <source>item %1 is not part of questionnaire %2</source>
        <translation>pytanie %1 nie należy do kwestionariusza %2</translation>
    </message>
    <message>
        <source>%1 at %2 s</source>
        <translation>%1 w chwili %2 s</translation>
    </message>
    <message>
        <source>entries that were lost</source>
        <translation>utracone wpisy</translation>
    </message>
    <message>
        <source>frame or sample time</source>
        <translation>czas klatki lub próbki</translation>
    </message>
    <message>
        <source>the field</source>
        <translation>pole operacyjne</translation>
    </message>
    <message>
        <source>the instruments</source>
        <translation>narzędzia</translation>
    </message>
    <message>
        <source>event &quot;%1&quot;</source>
        <translation>zdarzenie „%1”</translation>
    </message>
    <message>
        <source>a sample</source>
        <translation>próbka</translation>
    </message>
    <message>
        <source>state</source>
        <translation>stan</translation>
    </message>
    <message>
        <source>the number of samples</source>
        <translation>liczba próbek</translation>
    </message>
    <message>
        <source>the duration</source>
        <translation>czas trwania</translation>
    </message>
    <message>
        <source>the number of events</source>
        <translation>liczba zdarzeń</translation>
    </message>
    <message>
        <source>its records are kept until %1</source>
        <translation>jego zapisy przechowuje się do %1</translation>
    </message>
    <message>
        <source>event %1 (%2) has the value %3, expected 0 or more</source>
        <translation>zdarzenie %1 (%2) ma wartość %3, a oczekiwano 0 lub więcej</translation>
    </message>
    <message>
        <source>it has %1 entries of &quot;%2&quot;, and %3 are told</source>
        <translation>ma %1 wpisów „%2”, a podano %3</translation>
    </message>
    <message>
        <source>the course is not mastered</source>
        <translation>kurs nie jest zaliczony</translation>
    </message>
    <message>
        <source>the certificate %1 that is there says that the course was mastered at %2, and the attempts say %3; show this to an administrator</source>
        <translation>istniejący certyfikat %1 mówi, że kurs zaliczono %2, a z prób wynika %3; pokaż to administratorowi</translation>
    </message>
    <message>
        <source>version %1 of its task is published, and this program has version %2; update Placode</source>
        <translation>opublikowano wersję %1 zadania, a ten program ma wersję %2; zaktualizuj Placode</translation>
    </message>
    <message>
        <source>another case is due by now; open the exam again</source>
        <translation>teraz kolej na inny przypadek; otwórz egzamin ponownie</translation>
    </message>
    <message>
        <source>the clocks of this computer and of the server differ; an administrator sets them</source>
        <translation>zegary tego komputera i serwera się różnią; administrator je ustawi</translation>
    </message>
    <message>
        <source>nobody has vouched for this computer, so an exam would not count; an administrator does: placodectl station trust</source>
        <translation>nikt nie poręczył za ten komputer, więc egzamin by się nie liczył; robi to administrator: placodectl station trust</translation>
    </message>
    <message>
        <source>it was not recorded as an exam</source>
        <translation>nie nagrano tego jako egzaminu</translation>
    </message>
    <message>
        <source>another case is due by now</source>
        <translation>teraz kolej na inny przypadek</translation>
    </message>
    <message>
        <source>it was not begun here, or is saved already</source>
        <translation>nie rozpoczęto go tutaj albo jest już zapisany</translation>
    </message>
    <message>
        <source>it was not begun here, and neither a proctor nor an administrator vouches for it</source>
        <translation>nie rozpoczęto go tutaj i nie ręczy za niego ani osoba nadzorująca, ani administrator</translation>
    </message>
    <message>
        <source>somebody for a demonstration (%1)</source>
        <translation>ktoś w ramach pokazu (%1)</translation>
    </message>
    <message>
        <source>attempt %1 was not recorded for a study under your account</source>
        <translation>próby %1 nie nagrano dla badania na twoim koncie</translation>
    </message>
    <message>
        <source>attempt %1 is of the task &quot;%2&quot;; this step asks for &quot;%3&quot;</source>
        <translation>próba %1 dotyczy zadania „%2”; ten krok wymaga zadania „%3”</translation>
    </message>
    <message>
        <source>attempt %1 does the step &quot;%2&quot; of visit %3 of %4 already</source>
        <translation>próba %1 wykonuje już krok „%2” wizyty %3, uczestnik %4</translation>
    </message>
</context>
<context>
    <name>placode::ui::Details</name>
    <message>
        <source>Copy</source>
        <translation>Kopiuj</translation>
    </message>
    <message>
        <source>Copy the details</source>
        <translation>Kopiuj szczegóły</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Skopiowano</translation>
    </message>
    <message>
        <source>Hide details</source>
        <translation>Ukryj szczegóły</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Szczegóły</translation>
    </message>
    <message>
        <source>Shows the exact message.</source>
        <translation>Pokazuje dokładną treść komunikatu.</translation>
    </message>
    <message>
        <source>The exact message</source>
        <translation>Dokładny komunikat</translation>
    </message>
</context>
<context>
    <name>placode::ui::Notices</name>
    <message>
        <source>%1, longer than usual</source>
        <translation>%1, dłużej niż zwykle</translation>
    </message>
    <message>
        <source>Work in progress</source>
        <translation>Praca w toku</translation>
    </message>
    <message>
        <source>More messages: %1</source>
        <translation>Więcej wiadomości: %1</translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <translation>%1, jeszcze około %2</translation>
    </message>
</context>
<context>
    <name>ExamStandingWords</name>
    <message>
        <source>The number of attempts at this exam is not limited.</source>
        <translation>Liczba prób tego egzaminu nie jest ograniczona.</translation>
    </message>
    <message>
        <source>none is left</source>
        <translation>nie została żadna</translation>
    </message>
    <message>
        <source>left: %1</source>
        <translation>zostało: %1</translation>
    </message>
    <message>
        <source>It uses up one of the %1 attempts at this exam; %2.</source>
        <translation>Zużywa jedną z %1 prób tego egzaminu; %2.</translation>
    </message>
    <message>
        <source>It uses up none of the %1 attempts at this exam; %2.</source>
        <translation>Nie zużywa żadnej z %1 prób tego egzaminu; %2.</translation>
    </message>
    <message>
        <source>The exam is passed, and with it the course: the certificate is on the page Course.</source>
        <translation>Egzamin zdany, a z nim kurs: certyfikat jest na stronie Kurs.</translation>
    </message>
    <message>
        <source>The exam is passed.</source>
        <translation>Egzamin zdany.</translation>
    </message>
    <message>
        <source>The exam is passed. Next in the course: %1.</source>
        <translation>Egzamin zdany. Dalej w kursie: %1.</translation>
    </message>
    <message>
        <source>The exam is not passed. An educator can grant more attempts.</source>
        <translation>Egzamin nie jest zdany. Instruktor może przyznać dalsze próby.</translation>
    </message>
    <message>
        <source>To pass, the benchmark is still to be met in a row: %1 times.</source>
        <translation>Do zdania trzeba jeszcze osiągnąć próg z rzędu: %1 razy.</translation>
    </message>
    <message>
        <source>The next attempt at this exam has another case.</source>
        <translation>Następna próba tego egzaminu to inny przypadek.</translation>
    </message>
    <message>
        <source>The next attempt at this exam has the same case.</source>
        <translation>Następna próba tego egzaminu to ten sam przypadek.</translation>
    </message>
    <message>
        <source>The attempt counts.</source>
        <translation>Próba się liczy.</translation>
    </message>
</context>
<context>
    <name>placode::ui::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Pomoc</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Szukaj w podręczniku</translation>
    </message>
    <message>
        <source>Contents of the manual</source>
        <translation>Spis treści podręcznika</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Wstecz</translation>
    </message>
    <message>
        <source>Alt and left arrow</source>
        <translation>Alt i strzałka w lewo</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Dalej</translation>
    </message>
    <message>
        <source>Alt and right arrow</source>
        <translation>Alt i strzałka w prawo</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Spis treści</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Escape</translation>
    </message>
    <message>
        <source>Nothing found. Try fewer letters.</source>
        <translation>Nic nie znaleziono. Spróbuj mniej liter.</translation>
    </message>
</context>
<context>
    <name>placode::ui::ManualView</name>
    <message>
        <source>Page of the manual</source>
        <translation>Strona podręcznika</translation>
    </message>
    <message>
        <source>This page of the manual is missing: %1</source>
        <translation>Brakuje tej strony podręcznika: %1</translation>
    </message>
</context>
<context>
    <name>StudyStanding</name>
    <message>
        <source>Skipped: %1.</source>
        <translation>Pominięto: %1.</translation>
    </message>
    <message>
        <source>Nothing was done: %1.</source>
        <translation>Nic nie wykonano: %1.</translation>
    </message>
    <message>
        <source>Withdrew.</source>
        <translation>Uczestnik się wycofał.</translation>
    </message>
    <message>
        <source>To be done again: %1.</source>
        <translation>Do powtórzenia: %1.</translation>
    </message>
    <message>
        <source>DEMONSTRATION</source>
        <translation>DEMONSTRACJA</translation>
    </message>
</context>
<context>
    <name>TrainingReports</name>
    <message>
        <source>Write the report</source>
        <translation>Zapisz raport</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Zapis raportu</translation>
    </message>
    <message>
        <source>Report written: %1</source>
        <translation>Raport zapisany: %1</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Raport</translation>
    </message>
    <message>
        <source>Of everybody</source>
        <translation>Wszystkich</translation>
    </message>
    <message>
        <source>Of the group %1</source>
        <translation>Grupy %1</translation>
    </message>
</context>
<context>
    <name>TraineeChooser</name>
    <message>
        <source>Nobody is chosen: type a name, or choose one of the list.</source>
        <translation>Nikogo nie wybrano: wpisz nazwisko albo wybierz z listy.</translation>
    </message>
    <message>
        <source>Several names match &quot;%1&quot;: %2; choose one of the list.</source>
        <translation>„%1” pasuje do kilku nazw: %2; wybierz jedną z listy.</translation>
    </message>
</context>
<context>
    <name>GrantsCard</name>
    <message>
        <source>Type a name, or choose from the list</source>
        <translation>Wpisz nazwisko albo wybierz z listy</translation>
    </message>
    <message>
        <source>More attempts</source>
        <translation>Dalsze próby</translation>
    </message>
    <message>
        <source>For somebody whose attempts at a stage were used up, or spoilt by what was not their fault. The grant and its reason stay in the audit.</source>
        <translation>Dla osoby, która wyczerpała próby na danym etapie albo której próby zepsuło coś niezależnego od niej. Przyznanie i jego powód zostają w dzienniku.</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Osoba</translation>
    </message>
    <message>
        <source>Stage with a limit of attempts</source>
        <translation>Etap z ograniczoną liczbą prób</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Próby</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Powód</translation>
    </message>
    <message>
        <source>e.g. the device was repaired</source>
        <translation>np. naprawiono urządzenie</translation>
    </message>
    <message>
        <source>Grant</source>
        <translation>Przyznaj</translation>
    </message>
    <message>
        <source>Reading where the person stands</source>
        <translation>Odczyt postępu osoby</translation>
    </message>
    <message>
        <source>Attempts made: %1</source>
        <translation>Wykonane próby: %1</translation>
    </message>
    <message>
        <source>left: %1</source>
        <translation>zostało: %1</translation>
    </message>
    <message>
        <source>%1 granted on %2 by %3 (%4)</source>
        <translation>%1 przyznano %2, przyznał(a) %3 (%4)</translation>
    </message>
    <message>
        <source>Granting attempts</source>
        <translation>Przyznawanie prób</translation>
    </message>
    <message>
        <source>There is nobody called &quot;%1&quot; whom you teach; choose one of the list.</source>
        <translation>Nie ma wśród Twoich podopiecznych osoby „%1”; wybierz kogoś z listy.</translation>
    </message>
    <message>
        <source>A grant needs a reason: why is this person to have more attempts than others?</source>
        <translation>Przyznanie wymaga powodu: dlaczego ta osoba ma mieć więcej prób niż inne?</translation>
    </message>
    <message>
        <source>More attempts for %1: %2.</source>
        <translation>Dalsze próby dla %1: %2.</translation>
    </message>
    <message>
        <source>begun, not finished: %1</source>
        <translation>rozpoczęte, nieukończone: %1</translation>
    </message>
</context>
<context>
    <name>PassphraseDialog</name>
    <message>
        <source>Passphrase of the centre&apos;s key</source>
        <translation>Hasło klucza ośrodka</translation>
    </message>
    <message>
        <source>New passphrase, at least %1 characters</source>
        <translation>Nowe hasło, co najmniej %1 znaków</translation>
    </message>
    <message>
        <source>Passphrase</source>
        <translation>Hasło klucza</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Jeszcze raz</translation>
    </message>
    <message>
        <source>Show what I type</source>
        <translation>Pokaż, co wpisuję</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Type the passphrase.</source>
        <translation>Wpisz hasło.</translation>
    </message>
    <message>
        <source>The two passphrases differ. Type both again.</source>
        <translation>Hasła się różnią. Wpisz oba jeszcze raz.</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>Podpisz</translation>
    </message>
    <message>
        <source>The centre&apos;s key is made now and signs this norm pack. Choose its passphrase: whoever signs packs of this centre needs it. Keep it in another place; without it only a new key helps.</source>
        <translation>Klucz ośrodka powstaje teraz i podpisuje ten pakiet norm. Wybierz jego hasło: potrzebuje go każdy, kto podpisuje pakiety tego ośrodka. Przechowuj je w innym miejscu; bez niego pomoże tylko nowy klucz.</translation>
    </message>
    <message>
        <source>The centre&apos;s key signs this norm pack. Until now it lay in clear in the store; it is put under a passphrase now. Keep it in another place; without it only a new key helps.</source>
        <translation>Klucz ośrodka podpisuje ten pakiet norm. Do tej pory leżał jawnie w bazie; teraz zostanie zabezpieczony hasłem. Przechowuj hasło w innym miejscu; bez niego pomoże tylko nowy klucz.</translation>
    </message>
    <message>
        <source>The key of %1 signs this norm pack.</source>
        <translation>Klucz ośrodka %1 podpisuje ten pakiet norm.</translation>
    </message>
</context>
<context>
    <name>Web</name>
    <message>
        <source>Main</source>
        <translation>Menu główne</translation>
    </message>
    <message>
        <source>My page</source>
        <translation>Moja strona</translation>
    </message>
    <message>
        <source>Cohort</source>
        <translation>Postępy</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Próby</translation>
    </message>
    <message>
        <source>Standards</source>
        <translation>Progi</translation>
    </message>
    <message>
        <source>Norms</source>
        <translation>Normy</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Badania</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Osoby</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Język</translation>
    </message>
    <message>
        <source>Skip to the content</source>
        <translation>Przejdź do treści</translation>
    </message>
    <message>
        <source>Sign out</source>
        <translation>Wyloguj się</translation>
    </message>
    <message>
        <source>Placode, for reading only: what is to be changed is changed in the program on the station. Times are UTC.</source>
        <translation>Placode, tylko do odczytu: zmian dokonuje się w programie na stanowisku. Godziny podano w UTC.</translation>
    </message>
    <message>
        <source>Sign in</source>
        <translation>Zaloguj się</translation>
    </message>
    <message>
        <source>With your account of Placode. Here everything is for reading only.</source>
        <translation>Użyj swojego konta z programu Placode. Tutaj wszystko jest tylko do odczytu.</translation>
    </message>
    <message>
        <source>Log-in name</source>
        <translation>Login</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Hasło</translation>
    </message>
    <message>
        <source>That page was too old, or cookies are off. Try again.</source>
        <translation>Ta strona była zbyt stara albo pliki cookie są wyłączone. Spróbuj ponownie.</translation>
    </message>
    <message>
        <source>Type your log-in name and your password.</source>
        <translation>Wpisz login i hasło.</translation>
    </message>
    <message>
        <source>Many people are signing in. Try again in a moment.</source>
        <translation>Loguje się wiele osób. Spróbuj ponownie za chwilę.</translation>
    </message>
    <message>
        <source>Too many wrong passwords. Try again in %1 s.</source>
        <translation>Zbyt wiele błędnych haseł. Spróbuj ponownie za %1 s.</translation>
    </message>
    <message>
        <source>This account is deactivated. An administrator can open it again.</source>
        <translation>To konto jest wyłączone. Administrator może je włączyć.</translation>
    </message>
    <message>
        <source>Log-in name or password is wrong. Try again.</source>
        <translation>Login lub hasło jest błędne. Spróbuj ponownie.</translation>
    </message>
    <message>
        <source>Somebody else chose your password and knows it. Sign in to the program Placode and choose your own, then come back.</source>
        <translation>Twoje hasło ustaliła inna osoba i je zna. Zaloguj się w programie Placode, wybierz własne hasło i wróć tutaj.</translation>
    </message>
    <message>
        <source>Not signed out</source>
        <translation>Nie wylogowano</translation>
    </message>
    <message>
        <source>That did not come from a page of this portal.</source>
        <translation>Żądanie nie pochodziło ze strony tego portalu.</translation>
    </message>
    <message>
        <source>You may not see this.</source>
        <translation>Nie możesz tego oglądać.</translation>
    </message>
    <message>
        <source>Back to my page</source>
        <translation>Powrót do mojej strony</translation>
    </message>
    <message>
        <source>Not for you</source>
        <translation>Brak dostępu</translation>
    </message>
    <message>
        <source>Not there</source>
        <translation>Nie znaleziono</translation>
    </message>
    <message>
        <source>What this page is about is not in the store.</source>
        <translation>W bazie nie ma tego, czego dotyczy ta strona.</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Chwilowo niedostępne</translation>
    </message>
    <message>
        <source>The store cannot be reached at the moment. Try again.</source>
        <translation>Baza jest w tej chwili nieosiągalna. Spróbuj ponownie.</translation>
    </message>
    <message>
        <source>Something is wrong</source>
        <translation>Wystąpił błąd</translation>
    </message>
    <message>
        <source>The store cannot be read. Whoever runs this computer finds the reason in the program&apos;s log.</source>
        <translation>Nie można odczytać bazy. Przyczynę znajdzie w dzienniku programu osoba, która zarządza tym komputerem.</translation>
    </message>
    <message>
        <source>The page could not be made. Whoever runs this computer finds the reason in the program&apos;s log.</source>
        <translation>Nie udało się utworzyć strony. Przyczynę znajdzie w dzienniku programu osoba, która zarządza tym komputerem.</translation>
    </message>
    <message>
        <source>There is no such page.</source>
        <translation>Nie ma takiej strony.</translation>
    </message>
    <message>
        <source>For reading only</source>
        <translation>Tylko do odczytu</translation>
    </message>
    <message>
        <source>Nothing can be sent to this page.</source>
        <translation>Na tę stronę nie można niczego wysłać.</translation>
    </message>
    <message>
        <source>Too long</source>
        <translation>Zbyt długie żądanie</translation>
    </message>
    <message>
        <source>The request is longer than any page asks for.</source>
        <translation>Żądanie jest dłuższe, niż potrzebuje jakakolwiek strona.</translation>
    </message>
    <message>
        <source>Not understood</source>
        <translation>Niezrozumiałe żądanie</translation>
    </message>
    <message>
        <source>The request cannot be read.</source>
        <translation>Nie można odczytać żądania.</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Zaliczone</translation>
    </message>
    <message>
        <source>Not yet</source>
        <translation>Jeszcze nie</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Niezaliczone</translation>
    </message>
    <message>
        <source>Not attempted</source>
        <translation>Nic nie zrobiono</translation>
    </message>
    <message>
        <source>does not count</source>
        <translation>nie liczy się</translation>
    </message>
    <message>
        <source>DEMONSTRATION</source>
        <translation>DEMONSTRACJA</translation>
    </message>
    <message>
        <source>DEMONSTRATION, simulated data</source>
        <translation>DEMONSTRACJA, dane symulowane</translation>
    </message>
    <message>
        <source>not tried</source>
        <translation>bez prób</translation>
    </message>
    <message>
        <source>learning</source>
        <translation>uczy się</translation>
    </message>
    <message>
        <source>passing</source>
        <translation>zalicza</translation>
    </message>
    <message>
        <source>regressed</source>
        <translation>regres</translation>
    </message>
    <message>
        <source>stuck</source>
        <translation>zastój</translation>
    </message>
    <message>
        <source>Stuck: none of the last %1 attempts passed and no gain of %2 points. Regressed: passed before, but neither of the last two attempts.</source>
        <translation>Zastój: żadnej z ostatnich %1 prób nie zaliczono i wynik nie wzrósł o %2 punkty. Regres: wcześniej zaliczano, ale żadnej z ostatnich dwóch prób nie zaliczono.</translation>
    </message>
    <message>
        <source>trainee</source>
        <translation>uczestnik szkolenia</translation>
    </message>
    <message>
        <source>educator</source>
        <translation>instruktor</translation>
    </message>
    <message>
        <source>coordinator</source>
        <translation>koordynator</translation>
    </message>
    <message>
        <source>administrator</source>
        <translation>administrator</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>numer %1</translation>
    </message>
    <message>
        <source>Pages of the list</source>
        <translation>Strony listy</translation>
    </message>
    <message>
        <source>← Before</source>
        <translation>← Poprzednie</translation>
    </message>
    <message>
        <source>Next →</source>
        <translation>Następne →</translation>
    </message>
    <message>
        <source>%1 to %2 of %3</source>
        <translation>%1 do %2 z %3</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Pokaż</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupa</translation>
    </message>
    <message>
        <source>Everybody</source>
        <translation>Wszyscy</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Osoba</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Zadanie</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkty</translation>
    </message>
    <message>
        <source>points</source>
        <translation>punkty</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ocena</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Powód</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stan</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Jednostka</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Ostatni wynik</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Najlepszy wynik</translation>
    </message>
    <message>
        <source>Last on</source>
        <translation>Ostatnia próba</translation>
    </message>
    <message>
        <source>Standing</source>
        <translation>Postęp</translation>
    </message>
    <message>
        <source>There are no attempts yet.</source>
        <translation>Nie ma jeszcze prób.</translation>
    </message>
    <message>
        <source>There is no such person.</source>
        <translation>Nie ma takiej osoby.</translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>Próba</translation>
    </message>
    <message>
        <source>Attempt %1</source>
        <translation>Próba %1</translation>
    </message>
    <message>
        <source>Attempt #%1</source>
        <translation>Próba nr %1</translation>
    </message>
    <message>
        <source>%1 of 100 points</source>
        <translation>%1 na 100 punktów</translation>
    </message>
    <message>
        <source>Started</source>
        <translation>Rozpoczęto</translation>
    </message>
    <message>
        <source>Started (UTC)</source>
        <translation>Rozpoczęto (UTC)</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Czas trwania</translation>
    </message>
    <message>
        <source>Why it does not count</source>
        <translation>Dlaczego się nie liczy</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s), newest first</source>
        <translation>
            <numerusform>%n próba, od najnowszej</numerusform>
            <numerusform>%n próby, od najnowszej</numerusform>
            <numerusform>%n prób, od najnowszej</numerusform>
        </translation>
    </message>
    <message>
        <source>There are no attempts here.</source>
        <translation>Nie ma tu prób.</translation>
    </message>
    <message>
        <source>All tasks</source>
        <translation>Wszystkie zadania</translation>
    </message>
    <message>
        <source>Attempts of %1</source>
        <translation>Próby: %1</translation>
    </message>
    <message>
        <source>%1 only</source>
        <translation>tylko %1</translation>
    </message>
    <message>
        <source>all tasks</source>
        <translation>wszystkie zadania</translation>
    </message>
    <message>
        <source>It counts.</source>
        <translation>Liczy się.</translation>
    </message>
    <message>
        <source>It does not count: %1.</source>
        <translation>Nie liczy się: %1.</translation>
    </message>
    <message>
        <source>About it</source>
        <translation>O tej próbie</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>Uczestnik badania</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Zakończenie</translation>
    </message>
    <message>
        <source>running</source>
        <translation>trwa</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>zakończona</translation>
    </message>
    <message>
        <source>time limit</source>
        <translation>limit czasu</translation>
    </message>
    <message>
        <source>closed@attempt</source>
        <translation>zatrzymana</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>przerwana</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Urządzenie</translation>
    </message>
    <message>
        <source>mouse</source>
        <translation>mysz</translation>
    </message>
    <message>
        <source>keyboard</source>
        <translation>klawiatura</translation>
    </message>
    <message>
        <source>gamepad</source>
        <translation>pad</translation>
    </message>
    <message>
        <source>scripted expert</source>
        <translation>program: ekspert</translation>
    </message>
    <message>
        <source>scripted intermediate</source>
        <translation>program: średnio zaawansowany</translation>
    </message>
    <message>
        <source>scripted novice</source>
        <translation>program: początkujący</translation>
    </message>
    <message>
        <source>Exam</source>
        <translation>Egzamin</translation>
    </message>
    <message>
        <source>Proctor</source>
        <translation>Osoba nadzorująca</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Oznaczenie</translation>
    </message>
    <message>
        <source>Scored by</source>
        <translation>Kryteria oceny</translation>
    </message>
    <message>
        <source>%1 %2, metric set %3</source>
        <translation>%1 %2, zestaw miar %3</translation>
    </message>
    <message>
        <source>What cost points</source>
        <translation>Co kosztowało punkty</translation>
    </message>
    <message>
        <source>No point was lost.</source>
        <translation>Bez straty punktów.</translation>
    </message>
    <message>
        <source>Reasons, the most costly first</source>
        <translation>Powody, od najkosztowniejszego</translation>
    </message>
    <message>
        <source>At@time</source>
        <translation>Czas</translation>
    </message>
    <message>
        <source>critical</source>
        <translation>krytyczne</translation>
    </message>
    <message>
        <source>Damage ledger</source>
        <translation>Rejestr uszkodzeń</translation>
    </message>
    <message>
        <source>Nothing was harmed that the ledger watches.</source>
        <translation>Nie uszkodzono niczego, co śledzi rejestr.</translation>
    </message>
    <message>
        <source>Damage ledger on a time line</source>
        <translation>Rejestr uszkodzeń na osi czasu</translation>
    </message>
    <message>
        <source>Phases above, one lane for each kind of harm; the table below lists the entries.</source>
        <translation>U góry fazy, niżej osobny pas dla każdego rodzaju uszkodzeń; wpisy wymienia tabela poniżej.</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(ies) of the damage ledger</source>
        <translation>
            <numerusform>%n wpis w rejestrze uszkodzeń</numerusform>
            <numerusform>%n wpisy w rejestrze uszkodzeń</numerusform>
            <numerusform>%n wpisów w rejestrze uszkodzeń</numerusform>
        </translation>
    </message>
    <message>
        <source>What</source>
        <translation>Co się stało</translation>
    </message>
    <message>
        <source>%1 o&apos;clock</source>
        <translation>godzina %1</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Miary</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Miara</translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation>Co zmierzono</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wartość</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Obszar</translation>
    </message>
    <message>
        <source>None was kept.</source>
        <translation>Nie zachowano żadnych.</translation>
    </message>
    <message>
        <source>Time and view</source>
        <translation>Czas i widok</translation>
    </message>
    <message>
        <source>Incision</source>
        <translation>Nacięcie</translation>
    </message>
    <message>
        <source>Placode@part</source>
        <translation>Płytka nerwowa</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Tkanka</translation>
    </message>
    <message>
        <source>Grasping and resection</source>
        <translation>Chwytanie i wycięcie</translation>
    </message>
    <message>
        <source>Energy and heat</source>
        <translation>Energia i ciepło</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Siła</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Ruch</translation>
    </message>
    <message>
        <source>Both hands</source>
        <translation>Obie ręce</translation>
    </message>
    <message>
        <source>Steps of the exercise</source>
        <translation>Kroki ćwiczenia</translation>
    </message>
    <message>
        <source>Closed wound</source>
        <translation>Zamknięcie rany</translation>
    </message>
    <message>
        <source>Needle and thread</source>
        <translation>Igła i nić</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Uwagi</translation>
    </message>
    <message>
        <source>(a mark)</source>
        <translation>(zaznaczenie)</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>w chwili %1</translation>
    </message>
    <message>
        <source>Nobody has remarked on it.</source>
        <translation>Nie ma uwag do tej próby.</translation>
    </message>
    <message>
        <source>Later scores</source>
        <translation>Późniejsze oceny</translation>
    </message>
    <message>
        <source>Later scores; the first one never changes</source>
        <translation>Późniejsze oceny; pierwsza nigdy się nie zmienia</translation>
    </message>
    <message>
        <source>Scored on</source>
        <translation>Oceniono</translation>
    </message>
    <message>
        <source>Rubric</source>
        <translation>Kryteria</translation>
    </message>
    <message>
        <source>People by tasks</source>
        <translation>Osoby i zadania</translation>
    </message>
    <message>
        <source>Who needs help</source>
        <translation>Kto potrzebuje pomocy</translation>
    </message>
    <message>
        <source>Due for a refresher</source>
        <translation>Do odświeżenia</translation>
    </message>
    <message>
        <source>Scores of a task</source>
        <translation>Wyniki zadania</translation>
    </message>
    <message>
        <source>Nobody here has an attempt that counts.</source>
        <translation>Nikt tu nie ma próby, która się liczy.</translation>
    </message>
    <message numerus="yes">
        <source>%n person(s) with attempts</source>
        <translation>
            <numerusform>%n osoba z próbami</numerusform>
            <numerusform>%n osoby z próbami</numerusform>
            <numerusform>%n osób z próbami</numerusform>
        </translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation>Ostatnio</translation>
    </message>
    <message>
        <source>Last score, standing and number of attempts.</source>
        <translation>Ostatni wynik, postęp i liczba prób.</translation>
    </message>
    <message>
        <source>%1 stuck, %2 regressed; who is stuck stands first</source>
        <translation>Zastój: %1, regres: %2; najpierw zastój</translation>
    </message>
    <message>
        <source>Nobody is stuck or regressed.</source>
        <translation>Nikt nie utknął ani się nie cofnął.</translation>
    </message>
    <message>
        <source>It points at people to look at and does not judge them.</source>
        <translation>To wskazówka, komu warto się przyjrzeć, a nie ocena tych osób.</translation>
    </message>
    <message>
        <source>Not practised for</source>
        <translation>Bez ćwiczeń</translation>
    </message>
    <message>
        <source>1 month or longer</source>
        <translation>od miesiąca lub dłużej</translation>
    </message>
    <message>
        <source>5 months or longer</source>
        <translation>od 5 miesięcy lub dłużej</translation>
    </message>
    <message numerus="yes">
        <source>%n person(s) and task(s) passed once and not practised since, the longest first</source>
        <translation>
            <numerusform>%n pozycja: zadanie zaliczone, a potem niećwiczone, od najdłuższej przerwy</numerusform>
            <numerusform>%n pozycje: zadania zaliczone, a potem niećwiczone, od najdłuższej przerwy</numerusform>
            <numerusform>%n pozycji: zadania zaliczone, a potem niećwiczone, od najdłuższej przerwy</numerusform>
        </translation>
    </message>
    <message>
        <source>Due</source>
        <translation>Zaległość</translation>
    </message>
    <message>
        <source>Days ago</source>
        <translation>Dni temu</translation>
    </message>
    <message>
        <source>since 5 months</source>
        <translation>od 5 miesięcy</translation>
    </message>
    <message>
        <source>since 1 month</source>
        <translation>od miesiąca</translation>
    </message>
    <message>
        <source>Nobody is due.</source>
        <translation>Nikt nie ma zaległości.</translation>
    </message>
    <message>
        <source>A month is 30 days and counts from the last attempt that counts, of tasks with at least one pass. When a stage of a course is to be refreshed by the course&apos;s own rule stands on the person&apos;s page.</source>
        <translation>Miesiąc to 30 dni od ostatniej próby, która się liczy, w zadaniach zaliczonych co najmniej raz. Kiedy etap kursu trzeba odświeżyć według zasad samego kursu, podaje strona osoby.</translation>
    </message>
    <message>
        <source>first attempt</source>
        <translation>pierwsza próba</translation>
    </message>
    <message>
        <source>last attempt</source>
        <translation>ostatnia próba</translation>
    </message>
    <message>
        <source>best attempt</source>
        <translation>najlepsza próba</translation>
    </message>
    <message>
        <source>Nobody here has an attempt at it that counts.</source>
        <translation>Nikt tu nie ma próby tego zadania, która się liczy.</translation>
    </message>
    <message>
        <source>Scores: %1</source>
        <translation>Wyniki: %1</translation>
    </message>
    <message>
        <source>score [points of 100]</source>
        <translation>wynik [punkty na 100]</translation>
    </message>
    <message numerus="yes">
        <source>%n person(s). Every point is a person; box: quartiles, line: median, diamond: mean.</source>
        <translation>
            <numerusform>%n osoba. Każdy punkt to osoba; prostokąt: kwartyle, linia: mediana, romb: średnia.</numerusform>
            <numerusform>%n osoby. Każdy punkt to osoba; prostokąt: kwartyle, linia: mediana, romb: średnia.</numerusform>
            <numerusform>%n osób. Każdy punkt to osoba; prostokąt: kwartyle, linia: mediana, romb: średnia.</numerusform>
        </translation>
    </message>
    <message>
        <source>Where to</source>
        <translation>Dokąd dalej</translation>
    </message>
    <message>
        <source>%1: everybody by tasks, %2, %3</source>
        <translation>%1: wszyscy według zadań, %2, %3</translation>
    </message>
    <message>
        <source>who needs help</source>
        <translation>kto potrzebuje pomocy</translation>
    </message>
    <message>
        <source>who is due for a refresher</source>
        <translation>kto powinien odświeżyć umiejętności</translation>
    </message>
    <message>
        <source>%1: flow, completeness, double entry, deviations, locks</source>
        <translation>%1: przebieg, kompletność, podwójne wprowadzanie, odstępstwa, blokady</translation>
    </message>
    <message>
        <source>%1: accounts, roles, groups</source>
        <translation>%1: konta, role, grupy</translation>
    </message>
    <message>
        <source>account closed</source>
        <translation>konto wyłączone</translation>
    </message>
    <message>
        <source>Courses</source>
        <translation>Kursy</translation>
    </message>
    <message>
        <source>No course is assigned.</source>
        <translation>Nie przydzielono kursu.</translation>
    </message>
    <message>
        <source>Certificate %1 of %2.</source>
        <translation>Certyfikat %1, wydano %2.</translation>
    </message>
    <message>
        <source>Stages of %1</source>
        <translation>Etapy: %1</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Etap</translation>
    </message>
    <message>
        <source>(exam)</source>
        <translation>(egzamin)</translation>
    </message>
    <message>
        <source>Met in a row</source>
        <translation>Z rzędu</translation>
    </message>
    <message>
        <source>Benchmark</source>
        <translation>Próg</translation>
    </message>
    <message>
        <source>Attempts that count</source>
        <translation>Liczące się próby</translation>
    </message>
    <message>
        <source>Mastered on</source>
        <translation>Zaliczono</translation>
    </message>
    <message>
        <source>Refresh from</source>
        <translation>Odświeżyć od</translation>
    </message>
    <message>
        <source>refresher due</source>
        <translation>do odświeżenia</translation>
    </message>
    <message>
        <source>mastered</source>
        <translation>zaliczony</translation>
    </message>
    <message>
        <source>open@stage</source>
        <translation>otwarty</translation>
    </message>
    <message>
        <source>attempts used up</source>
        <translation>próby wykorzystane</translation>
    </message>
    <message>
        <source>locked@stage</source>
        <translation>zamknięty</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Zadania</translation>
    </message>
    <message>
        <source>No attempt counts yet.</source>
        <translation>Żadna próba jeszcze się nie liczy.</translation>
    </message>
    <message>
        <source>Where this person stands in each task</source>
        <translation>Postępy w poszczególnych zadaniach</translation>
    </message>
    <message>
        <source>Mean of last 3</source>
        <translation>Średnia z 3 ostatnich</translation>
    </message>
    <message>
        <source>Open a task to see its learning curve.</source>
        <translation>Otwórz zadanie, aby zobaczyć krzywą uczenia.</translation>
    </message>
    <message>
        <source>Newest attempts</source>
        <translation>Najnowsze próby</translation>
    </message>
    <message numerus="yes">
        <source>All of them: %n attempt(s)</source>
        <translation>
            <numerusform>Wszystkie: %n próba</numerusform>
            <numerusform>Wszystkie: %n próby</numerusform>
            <numerusform>Wszystkie: %n prób</numerusform>
        </translation>
    </message>
    <message>
        <source>Learning curve</source>
        <translation>Krzywa uczenia</translation>
    </message>
    <message>
        <source>Learning curve: %1</source>
        <translation>Krzywa uczenia: %1</translation>
    </message>
    <message>
        <source>Scores over attempts and, below, the CUSUM of attempts that were not passed (Bolsin &amp; Colson 2000) with its limits; p0 %1, p1 %2, alpha %3, beta %4.</source>
        <translation>Wyniki kolejnych prób, a poniżej CUSUM niezaliczonych prób (Bolsin i Colson 2000) z granicami; p0 %1, p1 %2, alfa %3, beta %4.</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s), last %1, best %2, pass mark %3</source>
        <translation>
            <numerusform>%n próba, ostatni wynik %1, najlepszy %2, próg zaliczenia %3</numerusform>
            <numerusform>%n próby, ostatni wynik %1, najlepszy %2, próg zaliczenia %3</numerusform>
            <numerusform>%n prób, ostatni wynik %1, najlepszy %2, próg zaliczenia %3</numerusform>
        </translation>
    </message>
    <message>
        <source>The attempts behind it</source>
        <translation>Próby, z których powstała</translation>
    </message>
    <message>
        <source>This person has no attempt at that task that counts.</source>
        <translation>Ta osoba nie ma próby tego zadania, która się liczy.</translation>
    </message>
    <message>
        <source>Name or log-in</source>
        <translation>Nazwisko lub login</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Szukaj</translation>
    </message>
    <message numerus="yes">
        <source>%n account(s)</source>
        <translation>
            <numerusform>%n konto</numerusform>
            <numerusform>%n konta</numerusform>
            <numerusform>%n kont</numerusform>
        </translation>
    </message>
    <message>
        <source>Log-in</source>
        <translation>Login</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>Role</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Grupy</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Od</translation>
    </message>
    <message>
        <source>%1 (teaches)</source>
        <translation>%1 (prowadzi)</translation>
    </message>
    <message>
        <source>open@account</source>
        <translation>włączone</translation>
    </message>
    <message>
        <source>closed@account</source>
        <translation>wyłączone</translation>
    </message>
    <message>
        <source>Nobody has that name.</source>
        <translation>Nikogo nie znaleziono.</translation>
    </message>
    <message>
        <source>Pass marks that hold now</source>
        <translation>Obowiązujące progi zaliczenia</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>Próg zaliczenia</translation>
    </message>
    <message>
        <source>Set on</source>
        <translation>Ustalono</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Kto ustalił</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Podstawa</translation>
    </message>
    <message>
        <source>the task&apos;s own mark</source>
        <translation>własny próg zadania</translation>
    </message>
    <message numerus="yes">
        <source>%n judge(s), standard error %1</source>
        <translation>
            <numerusform>%n sędzia, błąd standardowy %1</numerusform>
            <numerusform>%n sędziów, błąd standardowy %1</numerusform>
            <numerusform>%n sędziów, błąd standardowy %1</numerusform>
        </translation>
    </message>
    <message>
        <source>contrasting groups, novices: %1, experts: %2; novices who pass: %3 % by the curves, %4 % observed</source>
        <translation>grupy kontrastowe, początkujący: %1, eksperci: %2; początkujący powyżej progu: %3 % z krzywych, %4 % zaobserwowano</translation>
    </message>
    <message>
        <source>An attempt keeps the verdict of its day. Standards are set in Placode, on the page Standards.</source>
        <translation>Próba zachowuje ocenę z dnia wykonania. Progi ustala się w Placode, na stronie Progi.</translation>
    </message>
    <message>
        <source>Norm packs</source>
        <translation>Pakiety norm</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Ośrodek</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Utworzono</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Klucz</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Użycie</translation>
    </message>
    <message>
        <source>in use</source>
        <translation>w użyciu</translation>
    </message>
    <message>
        <source>There are no packs yet.</source>
        <translation>Nie ma jeszcze pakietów.</translation>
    </message>
    <message>
        <source>Bands of persons&apos; means, never of fewer than %1 people and never a single attempt, signed by their centre.</source>
        <translation>Pasma średnich osób, nigdy z mniej niż %1 osób i nigdy z pojedynczej próby, podpisane przez ośrodek.</translation>
    </message>
    <message>
        <source>Norms: %1</source>
        <translation>Normy: %1</translation>
    </message>
    <message>
        <source>All packs</source>
        <translation>Wszystkie pakiety</translation>
    </message>
    <message>
        <source>%1, made on %2, rubric %3 %4</source>
        <translation>%1, utworzono %2, kryteria %3 %4</translation>
    </message>
    <message>
        <source>experts</source>
        <translation>eksperci</translation>
    </message>
    <message>
        <source>novices</source>
        <translation>początkujący</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n person(s)</source>
        <translation>
            <numerusform>%1: %n osoba</numerusform>
            <numerusform>%1: %n osoby</numerusform>
            <numerusform>%1: %n osób</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, %n attempt(s)</source>
        <translation>
            <numerusform>%1, %n próba</numerusform>
            <numerusform>%1, %n próby</numerusform>
            <numerusform>%1, %n prób</numerusform>
        </translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Średnia</translation>
    </message>
    <message>
        <source>SD</source>
        <translation>SD</translation>
    </message>
    <message>
        <source>There is no such norm pack.</source>
        <translation>Nie ma takiego pakietu norm.</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Badanie</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Identyfikator</translation>
    </message>
    <message>
        <source>Studies with participants or a published protocol</source>
        <translation>Badania z uczestnikami lub opublikowanym protokołem</translation>
    </message>
    <message>
        <source>There is no study yet.</source>
        <translation>Nie ma jeszcze badań.</translation>
    </message>
    <message>
        <source>There is no such study.</source>
        <translation>Nie ma takiego badania.</translation>
    </message>
    <message>
        <source>Nobody takes part yet.</source>
        <translation>Nikt jeszcze nie bierze udziału.</translation>
    </message>
    <message>
        <source>Flow and records</source>
        <translation>Przebieg i rekordy</translation>
    </message>
    <message>
        <source>Double entry and corrections</source>
        <translation>Podwójne wprowadzanie i poprawki</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>Odstępstwa</translation>
    </message>
    <message>
        <source>At a glance</source>
        <translation>W skrócie</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Uczestnicy</translation>
    </message>
    <message>
        <source>Complete@participants</source>
        <translation>Kompletni</translation>
    </message>
    <message>
        <source>Withdrew@participants</source>
        <translation>Wycofani</translation>
    </message>
    <message>
        <source>Locked@records</source>
        <translation>Zablokowane rekordy</translation>
    </message>
    <message>
        <source>Signed@records</source>
        <translation>Podpisane rekordy</translation>
    </message>
    <message>
        <source>Open differences</source>
        <translation>Otwarte różnice</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>Poprawki</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Przepływ</translation>
    </message>
    <message>
        <source>Flow of participants</source>
        <translation>Przepływ uczestników</translation>
    </message>
    <message>
        <source>Flow of participants.</source>
        <translation>Przepływ uczestników.</translation>
    </message>
    <message>
        <source>enrolled</source>
        <translation>włączeni</translation>
    </message>
    <message>
        <source>withdrew, data not used or erased</source>
        <translation>wycofani, dane nieużywane lub usunięte</translation>
    </message>
    <message>
        <source>withdrew, data to date are used</source>
        <translation>wycofani, dotychczasowe dane używane</translation>
    </message>
    <message>
        <source>consented</source>
        <translation>wyrazili zgodę</translation>
    </message>
    <message>
        <source>answers or attempts analysed</source>
        <translation>odpowiedzi lub próby w analizie</translation>
    </message>
    <message>
        <source>Records</source>
        <translation>Rekordy</translation>
    </message>
    <message>
        <source>Records by code</source>
        <translation>Rekordy według kodów</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Kod</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Kroki</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Krok</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Następny krok</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Odpowiedzi</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Rekord</translation>
    </message>
    <message>
        <source>Last step on</source>
        <translation>Ostatni krok</translation>
    </message>
    <message>
        <source>open@record</source>
        <translation>otwarty</translation>
    </message>
    <message>
        <source>locked@record</source>
        <translation>zablokowany</translation>
    </message>
    <message>
        <source>locked and signed</source>
        <translation>zablokowany i podpisany</translation>
    </message>
    <message>
        <source>CHANGED AFTER THE SIGNATURE</source>
        <translation>ZMIENIONY PO PODPISANIU</translation>
    </message>
    <message>
        <source>withdrew</source>
        <translation>wycofanie</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>ukończone</translation>
    </message>
    <message>
        <source>under way</source>
        <translation>w toku</translation>
    </message>
    <message>
        <source>to be done again: %1</source>
        <translation>do powtórzenia: %1</translation>
    </message>
    <message>
        <source>Double entry</source>
        <translation>Podwójne wprowadzanie</translation>
    </message>
    <message>
        <source>%1: double entry</source>
        <translation>%1: podwójne wprowadzanie</translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s) was (were) typed a second time.</source>
        <translation>
            <numerusform>Drugi raz wpisano %n arkusz.</numerusform>
            <numerusform>Drugi raz wpisano %n arkusze.</numerusform>
            <numerusform>Drugi raz wpisano %n arkuszy.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n open difference(s)</source>
        <translation>
            <numerusform>%n otwarta różnica</numerusform>
            <numerusform>%n otwarte różnice</numerusform>
            <numerusform>%n otwartych różnic</numerusform>
        </translation>
    </message>
    <message>
        <source>There are no open differences.</source>
        <translation>Nie ma otwartych różnic.</translation>
    </message>
    <message>
        <source>Questionnaire</source>
        <translation>Kwestionariusz</translation>
    </message>
    <message>
        <source>Visit</source>
        <translation>Wizyta</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>Pytanie</translation>
    </message>
    <message>
        <source>First entry</source>
        <translation>Pierwsze wprowadzenie</translation>
    </message>
    <message>
        <source>Second entry</source>
        <translation>Drugie wprowadzenie</translation>
    </message>
    <message>
        <source>Corrections, with the old answer</source>
        <translation>Poprawki, z poprzednią odpowiedzią</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Dnia</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Przed</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Po</translation>
    </message>
    <message>
        <source>None.</source>
        <translation>Brak.</translation>
    </message>
    <message numerus="yes">
        <source>%n deviation(s) or note(s)</source>
        <translation>
            <numerusform>%n odstępstwo lub uwaga</numerusform>
            <numerusform>%n odstępstwa i uwagi</numerusform>
            <numerusform>%n odstępstw i uwag</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: deviations</source>
        <translation>%1: odstępstwa</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Rodzaj</translation>
    </message>
    <message>
        <source>visit %1</source>
        <translation>wizyta %1</translation>
    </message>
    <message>
        <source>All went as the protocol says.</source>
        <translation>Wszystko przebiegło zgodnie z protokołem.</translation>
    </message>
    <message>
        <source>Nobody writes these down: they follow from steps, attempts and the events of their recordings. Notes are the coordinator&apos;s.</source>
        <translation>Nikt ich nie wpisuje: wynikają z kroków, prób i zdarzeń w nagraniach. Uwagi pochodzą od koordynatora.</translation>
    </message>
    <message>
        <source>Review of attempt #%1</source>
        <translation>Przegląd próby #%1</translation>
    </message>
    <message>
        <source>Review of attempt %1</source>
        <translation>Przegląd próby %1</translation>
    </message>
    <message>
        <source>Back to the attempt</source>
        <translation>Wróć do próby</translation>
    </message>
    <message>
        <source>Look at it in 3D</source>
        <translation>Obejrzyj w 3D</translation>
    </message>
    <message>
        <source>The recording is being simulated again: %1 %.</source>
        <translation>Nagranie jest symulowane ponownie: %1 %.</translation>
    </message>
    <message>
        <source>Another recording is being simulated first.</source>
        <translation>Najpierw symulowane jest inne nagranie.</translation>
    </message>
    <message>
        <source>Several recordings wait to be simulated. This page asks again by itself.</source>
        <translation>Kilka nagrań czeka na symulację. Ta strona sama zapyta ponownie.</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Zasymulowano</translation>
    </message>
    <message>
        <source>It takes about as long as the attempt, once. The page shows it by itself.</source>
        <translation>Trwa to mniej więcej tyle co próba, jeden raz. Strona pokaże ją sama.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Odtwórz</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Zatrzymaj</translation>
    </message>
    <message>
        <source>The track is not in memory any more, or you are signed out. Load the page again.</source>
        <translation>Zapisu nie ma już w pamięci albo nastąpiło wylogowanie. Wczytaj stronę ponownie.</translation>
    </message>
    <message>
        <source>This browser cannot show it: it needs WebGL 2 and DecompressionStream.</source>
        <translation>Ta przeglądarka nie może tego pokazać: potrzebne są WebGL 2 i DecompressionStream.</translation>
    </message>
    <message>
        <source>Picture of the attempt. Arrow keys turn it, plus and minus bring it nearer.</source>
        <translation>Obraz próby. Strzałki obracają, plus i minus przybliżają i oddalają.</translation>
    </message>
    <message>
        <source>Time in the attempt</source>
        <translation>Czas próby</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>As the fetoscope saw it</source>
        <translation>Jak widział fetoskop</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Z góry</translation>
    </message>
    <message>
        <source>From the side</source>
        <translation>Z boku</translation>
    </message>
    <message>
        <source>Free: drag to turn, wheel to come nearer</source>
        <translation>Swobodna: przeciągnij, aby obrócić, kółko przybliża</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>The picture needs JavaScript.</source>
        <translation>Obraz wymaga JavaScriptu.</translation>
    </message>
    <message>
        <source>Moments; a click leads there</source>
        <translation>Chwile; kliknięcie prowadzi do nich</translation>
    </message>
    <message>
        <source>Moments</source>
        <translation>Chwile</translation>
    </message>
    <message>
        <source>Nothing was noted.</source>
        <translation>Niczego nie odnotowano.</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>zgodne</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>różni się</translation>
    </message>
    <message>
        <source>Simulated again from its recording: every recorded state came out the same.</source>
        <translation>Zasymulowano ponownie z nagrania: każdy zapisany stan wyszedł taki sam.</translation>
    </message>
    <message>
        <source>Simulated again from its recording, it differs from %1 on. What is shown ends there. Another version of the program may be the cause.</source>
        <translation>Ponowna symulacja nagrania różni się od %1. Obraz kończy się w tym miejscu. Przyczyną może być inna wersja programu.</translation>
    </message>
    <message>
        <source>Shapes, burns, cuts and instruments are those of the simulation; colours are plain. Blue: planned line, yellow: tissue to be taken out, until it is cut there.</source>
        <translation>Kształty, oparzenia, cięcia i narzędzia pochodzą z symulacji; kolory są uproszczone. Niebieska: planowana linia, żółta: tkanka do usunięcia, dopóki nie ma tam cięcia.</translation>
    </message>
    <message>
        <source>The attempt is longer than an hour; look at it in the program on the station.</source>
        <translation>Próba trwa ponad godzinę; obejrzyj ją w programie na stanowisku.</translation>
    </message>
    <message>
        <source>The attempt was kept without its recording.</source>
        <translation>Próbę zapisano bez nagrania.</translation>
    </message>
    <message>
        <source>The recording cannot be simulated by this version of the program.</source>
        <translation>Ta wersja programu nie może zasymulować tego nagrania.</translation>
    </message>
    <message>
        <source>Not signed in</source>
        <translation>Nie zalogowano</translation>
    </message>
    <message>
        <source>Signed in</source>
        <translation>Zalogowano</translation>
    </message>
    <message>
        <source>You are signed in as %1.</source>
        <translation>Zalogowano jako %1.</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Dalej</translation>
    </message>
    <message>
        <source>Not known here yet</source>
        <translation>Konto jeszcze nieznane</translation>
    </message>
    <message>
        <source>The platform&apos;s answer is incomplete or cannot be read.</source>
        <translation>Odpowiedź platformy jest niepełna albo nie da się jej odczytać.</translation>
    </message>
    <message>
        <source>The platform&apos;s answer is not signed with RS256.</source>
        <translation>Odpowiedź platformy nie jest podpisana algorytmem RS256.</translation>
    </message>
    <message>
        <source>The platform&apos;s answer is signed with a key that the platform does not publish, or its keys cannot be read now. Try again in a minute.</source>
        <translation>Odpowiedź platformy podpisano kluczem, którego platforma nie ogłasza, albo jej kluczy nie można teraz odczytać. Spróbuj ponownie za minutę.</translation>
    </message>
    <message>
        <source>The signature of the platform&apos;s answer is wrong.</source>
        <translation>Podpis odpowiedzi platformy jest nieprawidłowy.</translation>
    </message>
    <message>
        <source>The answer comes from another platform than the one that was asked.</source>
        <translation>Odpowiedź pochodzi z innej platformy niż zapytana.</translation>
    </message>
    <message>
        <source>The platform&apos;s answer is for another tool.</source>
        <translation>Odpowiedź platformy jest przeznaczona dla innego narzędzia.</translation>
    </message>
    <message>
        <source>The platform&apos;s answer is too old, or the clocks of platform and portal differ. Start again from your course.</source>
        <translation>Odpowiedź platformy jest za stara albo zegary platformy i portalu się różnią. Zacznij ponownie ze swojego kursu.</translation>
    </message>
    <message>
        <source>The platform&apos;s answer belongs to another sign-in. Start again from your course.</source>
        <translation>Odpowiedź platformy należy do innego logowania. Zacznij ponownie ze swojego kursu.</translation>
    </message>
    <message>
        <source>This deployment of the platform is not registered here.</source>
        <translation>To wdrożenie platformy nie jest tu zarejestrowane.</translation>
    </message>
    <message>
        <source>From a platform, links to this portal can be opened by LTI 1.3, and nothing else.</source>
        <translation>Z platformy można otwierać odnośniki do tego portalu przez LTI 1.3 i nic poza tym.</translation>
    </message>
    <message>
        <source>The platform did not say who you are.</source>
        <translation>Platforma nie podała, kim jesteś.</translation>
    </message>
    <message>
        <source>Nobody has said yet which account of Placode is yours. Give an administrator of Placode this address and this number of yours:</source>
        <translation>Nikt jeszcze nie wskazał, które konto Placode jest Twoje. Podaj administratorowi Placode ten adres i ten swój numer:</translation>
    </message>
    <message>
        <source>This platform is not registered here.</source>
        <translation>Ta platforma nie jest tu zarejestrowana.</translation>
    </message>
    <message>
        <source>This sign-in is too old or was used already. Start again from your course.</source>
        <translation>To logowanie jest za stare albo zostało już użyte. Zacznij ponownie ze swojego kursu.</translation>
    </message>
    <message>
        <source>This sign-in began in another browser, or cookies are off. Start again from your course.</source>
        <translation>To logowanie zaczęto w innej przeglądarce albo ciasteczka są wyłączone. Zacznij ponownie ze swojego kursu.</translation>
    </message>
    <message>
        <source>The platform did not sign you in: %1</source>
        <translation>Platforma nie potwierdziła logowania: %1</translation>
    </message>
    <message>
        <source>The account that you are linked with is closed or was changed. Ask an administrator of Placode.</source>
        <translation>Konto, z którym Cię powiązano, jest zamknięte albo zostało zmienione. Zapytaj administratora Placode.</translation>
    </message>
    <message>
        <source>Administrators sign in with their password.</source>
        <translation>Administratorzy logują się swoim hasłem.</translation>
    </message>
</context>
<context>
    <name>Attempt</name>
    <message>
        <source>Inspect</source>
        <translation>Oględziny</translation>
    </message>
    <message>
        <source>Incise</source>
        <translation>Nacięcie</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Uwolnienie</translation>
    </message>
    <message>
        <source>Resect</source>
        <translation>Wycięcie</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Kontrola</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Ćwiczenie</translation>
    </message>
    <message>
        <source>CUT</source>
        <translation>CIĘCIE</translation>
    </message>
    <message>
        <source>COAG</source>
        <translation>KOAG.</translation>
    </message>
    <message>
        <source>force</source>
        <translation>siła</translation>
    </message>
    <message>
        <source>needle</source>
        <translation>igła</translation>
    </message>
    <message>
        <source>hook</source>
        <translation>haczyk</translation>
    </message>
    <message>
        <source>grasper</source>
        <translation>chwytak</translation>
    </message>
    <message>
        <source>scissors</source>
        <translation>nożyczki</translation>
    </message>
    <message>
        <source>probe</source>
        <translation>sonda</translation>
    </message>
    <message>
        <source>needle driver</source>
        <translation>imadło</translation>
    </message>
    <message>
        <source>take the needle</source>
        <translation>chwyć igłę</translation>
    </message>
    <message>
        <source>hold the point here</source>
        <translation>trzymaj tu ostrze</translation>
    </message>
    <message>
        <source>lay the needle here</source>
        <translation>odłóż tu igłę</translation>
    </message>
    <message>
        <source>draw the needle through</source>
        <translation>przeciągnij igłę</translation>
    </message>
    <message>
        <source>draw the thread until the edges meet</source>
        <translation>ciągnij nić, aż brzegi się zetkną</translation>
    </message>
    <message>
        <source>smooth out the folds</source>
        <translation>wygładź fałdy</translation>
    </message>
    <message>
        <source>as far as the line, all round</source>
        <translation>aż do linii, dookoła</translation>
    </message>
    <message>
        <source>washed off: %1</source>
        <translation>spłukano: %1</translation>
    </message>
    <message>
        <source>dry: %1</source>
        <translation>odessano: %1</translation>
    </message>
    <message>
        <source>freed: %1</source>
        <translation>uwolniono: %1</translation>
    </message>
    <message>
        <source>irrigator</source>
        <translation>irygator</translation>
    </message>
    <message>
        <source>Jet presses on the placode</source>
        <translation>Strumień uciska płytkę</translation>
    </message>
    <message>
        <source>Suction holds tissue</source>
        <translation>Ssak trzyma tkankę</translation>
    </message>
    <message>
        <source>needle in</source>
        <translation>wkłucie</translation>
    </message>
    <message>
        <source>needle out</source>
        <translation>wykłucie</translation>
    </message>
    <message>
        <source>Tab: back to the %1</source>
        <translation>Tab: z powrotem %1</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>okrąg</translation>
    </message>
    <message>
        <source>out</source>
        <translation>wyjęto</translation>
    </message>
    <message>
        <source>of</source>
        <translation>z</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>pozostało %1</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>gotowe: %1</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>jeszcze %1</translation>
    </message>
    <message>
        <source>stuck</source>
        <translation>utkwiło</translation>
    </message>
    <message>
        <source>Stuck in tissue: draw back</source>
        <translation>Końcówka utkwiła w tkance: cofnij</translation>
    </message>
    <message>
        <source>Ring closed: lift the needle</source>
        <translation>Okrąg zamknięty: unieś igłę</translation>
    </message>
    <message>
        <source>%1 mm inside tissue</source>
        <translation>%1 mm w tkance</translation>
    </message>
    <message>
        <source>%1 mm above</source>
        <translation>%1 mm nad tkanką</translation>
    </message>
    <message>
        <source>%1 mm away</source>
        <translation>do celu %1 mm</translation>
    </message>
    <message>
        <source>straight down</source>
        <translation>prosto w dół</translation>
    </message>
    <message>
        <source>below the tip</source>
        <translation>pod końcówką</translation>
    </message>
    <message>
        <source>no contact: a little deeper</source>
        <translation>brak kontaktu: trochę głębiej</translation>
    </message>
    <message>
        <source>touches</source>
        <translation>dotyka</translation>
    </message>
    <message>
        <source>now the yellow pedal</source>
        <translation>teraz żółty pedał</translation>
    </message>
    <message>
        <source>now the blue pedal</source>
        <translation>teraz niebieski pedał</translation>
    </message>
    <message>
        <source>now hold the left button</source>
        <translation>teraz przytrzymaj lewy przycisk</translation>
    </message>
    <message>
        <source>now hold the right button</source>
        <translation>teraz przytrzymaj prawy przycisk</translation>
    </message>
    <message>
        <source>now hold X</source>
        <translation>teraz przytrzymaj X</translation>
    </message>
    <message>
        <source>now hold C</source>
        <translation>teraz przytrzymaj C</translation>
    </message>
    <message>
        <source>now close the jaws</source>
        <translation>teraz zamknij szczęki</translation>
    </message>
    <message>
        <source>open the jaws</source>
        <translation>otwórz szczęki</translation>
    </message>
    <message>
        <source>turn it on, then open the jaws</source>
        <translation>obracaj dalej, potem otwórz szczęki</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pauza</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Kontynuuj</translation>
    </message>
    <message>
        <source>Finish and score</source>
        <translation>Zakończ i oceń</translation>
    </message>
    <message>
        <source>Leave without finishing</source>
        <translation>Wyjdź bez kończenia</translation>
    </message>
    <message>
        <source>Arrows and Enter, or the mouse</source>
        <translation>Strzałki i Enter albo mysz</translation>
    </message>
    <message>
        <source>Controls</source>
        <translation>Sterowanie</translation>
    </message>
    <message>
        <source>DEMONSTRATION</source>
        <translation>POKAZ</translation>
    </message>
    <message>
        <source>F1 help   Esc pause   hold Enter: finish</source>
        <translation>F1 pomoc   Esc pauza   przytrzymaj Enter: koniec</translation>
    </message>
    <message>
        <source>F1 keys   Space pause   ← → 5 s   ↑ ↓ speed   V camera   Q close</source>
        <translation>F1 klawisze   Spacja pauza   ← → 5 s   ↑ ↓ prędkość   V kamera   Q zamknij</translation>
    </message>
    <message>
        <source>Replay: practice</source>
        <translation>Odtwarzanie: ćwiczenie</translation>
    </message>
    <message>
        <source>Preparing</source>
        <translation>Przygotowanie</translation>
    </message>
    <message>
        <source>Esc stops</source>
        <translation>Esc przerywa</translation>
    </message>
    <message>
        <source>Preparing stage: %1, %2 %</source>
        <translation>Przygotowanie etapu: %1, %2 %</translation>
    </message>
    <message>
        <source>Preparing what was given, %1 %</source>
        <translation>Przygotowanie tego, co było gotowe, %1 %</translation>
    </message>
    <message>
        <source>FROM A STAGE, not scored</source>
        <translation>OD ETAPU, bez oceny</translation>
    </message>
    <message>
        <source>Replay: exam</source>
        <translation>Odtwarzanie: egzamin</translation>
    </message>
    <message>
        <source>Replay: study</source>
        <translation>Odtwarzanie: badanie</translation>
    </message>
    <message>
        <source>Hold Enter to finish</source>
        <translation>Przytrzymaj Enter, aby zakończyć</translation>
    </message>
    <message>
        <source>The clock starts with your first motion</source>
        <translation>Zegar rusza z pierwszym ruchem</translation>
    </message>
    <message>
        <source>Paused: another window is in front</source>
        <translation>Pauza: na wierzchu jest inne okno</translation>
    </message>
    <message>
        <source>Paused: the gamepad is gone</source>
        <translation>Pauza: brak pada</translation>
    </message>
    <message>
        <source>Paused: the SpaceMouse is gone</source>
        <translation>Pauza: brak SpaceMouse</translation>
    </message>
    <message>
        <source>Paused: the computer was asleep</source>
        <translation>Pauza: komputer był uśpiony</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Zakończ</translation>
    </message>
    <message>
        <source>Finish the attempt?</source>
        <translation>Zakończyć próbę?</translation>
    </message>
    <message>
        <source>Leave the attempt?</source>
        <translation>Opuścić próbę?</translation>
    </message>
    <message>
        <source>Close the window?</source>
        <translation>Zamknąć okno?</translation>
    </message>
    <message>
        <source>Go on operating</source>
        <translation>Operuj dalej</translation>
    </message>
    <message>
        <source>The study asks for at least %1. Ended after %2 it does not count.</source>
        <translation>Badanie wymaga co najmniej %1. Zakończona po %2 nie liczy się.</translation>
    </message>
    <message>
        <source>Only %2 have passed; it usually takes %1.</source>
        <translation>Minęło dopiero %2; zwykle trwa to %1.</translation>
    </message>
    <message>
        <source>This is an exam: an end is final.</source>
        <translation>To jest egzamin: koniec jest ostateczny.</translation>
    </message>
    <message>
        <source>This is an exam: leaving uses up this attempt.</source>
        <translation>To jest egzamin: wyjście zużywa tę próbę.</translation>
    </message>
    <message>
        <source>The exam has not begun yet: leaving uses up nothing.</source>
        <translation>Egzamin jeszcze się nie zaczął: wyjście niczego nie zużywa.</translation>
    </message>
    <message>
        <source>Leave: uses up an attempt</source>
        <translation>Wyjdź: zużywa próbę</translation>
    </message>
    <message>
        <source>Leave: has to be done again</source>
        <translation>Wyjdź: trzeba powtórzyć od początku</translation>
    </message>
    <message>
        <source>A procedure that is broken off has to be done again from the start.</source>
        <translation>Przerwany zabieg trzeba powtórzyć od początku.</translation>
    </message>
    <message>
        <source>This procedure then is over for good.</source>
        <translation>Ten zabieg zakończy się wtedy na dobre.</translation>
    </message>
    <message>
        <source>An attempt that is left is kept as interrupted and counts for nothing.</source>
        <translation>Opuszczona próba zostaje zapisana jako przerwana i nie liczy się.</translation>
    </message>
    <message>
        <source>The attempt has not begun yet: nothing is kept.</source>
        <translation>Próba jeszcze się nie zaczęła: nic nie zostanie zapisane.</translation>
    </message>
    <message>
        <source>No tuning in a study</source>
        <translation>W badaniu nie ma strojenia</translation>
    </message>
    <message>
        <source>No help in an exam</source>
        <translation>Podczas egzaminu nie ma pomocy</translation>
    </message>
    <message>
        <source>This computer is too slow: the attempt will not count. Close other programs, or make the window smaller</source>
        <translation>Ten komputer jest za wolny: próba nie będzie się liczyć. Zamknij inne programy lub zmniejsz okno</translation>
    </message>
    <message>
        <source>This computer is slow: the picture was made simpler</source>
        <translation>Ten komputer jest wolny: uproszczono obraz</translation>
    </message>
    <message>
        <source>The field is being prepared ...</source>
        <translation>Pole operacyjne jest przygotowywane ...</translation>
    </message>
    <message>
        <source>Screenshot saved</source>
        <translation>Zapisano zrzut ekranu</translation>
    </message>
    <message>
        <source>Screenshot could not be saved</source>
        <translation>Nie udało się zapisać zrzutu ekranu</translation>
    </message>
    <message>
        <source>Placode touched</source>
        <translation>Dotknięto płytki nerwowej</translation>
    </message>
    <message>
        <source>Placode heated</source>
        <translation>Płytka nerwowa przegrzana</translation>
    </message>
    <message>
        <source>Placode burned</source>
        <translation>Płytka nerwowa oparzona</translation>
    </message>
    <message>
        <source>Beside the mark</source>
        <translation>Obok celu</translation>
    </message>
    <message>
        <source>TUNED, not scored</source>
        <translation>STROJONE, bez oceny</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Strojenie</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Tkanka</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Sztywność</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Tłumienie</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Tarcie</translation>
    </message>
    <message>
        <source>Failure stretch</source>
        <translation>Rozciągnięcie zerwania</translation>
    </message>
    <message>
        <source>Cut power</source>
        <translation>Moc cięcia</translation>
    </message>
    <message>
        <source>Coag power</source>
        <translation>Moc koagulacji</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Skóra</translation>
    </message>
    <message>
        <source>Thin skin</source>
        <translation>Cienka skóra</translation>
    </message>
    <message>
        <source>Subcutis</source>
        <translation>Tkanka podskórna</translation>
    </message>
    <message>
        <source>Muscle</source>
        <translation>Mięsień</translation>
    </message>
    <message>
        <source>Junctional zone</source>
        <translation>Strefa łącząca</translation>
    </message>
    <message>
        <source>Placode</source>
        <translation>Płytka nerwowa</translation>
    </message>
    <message>
        <source>Gel</source>
        <translation>Żel</translation>
    </message>
    <message>
        <source>Dura</source>
        <translation>Opona twarda</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Przywróć</translation>
    </message>
    <message>
        <source>Save as preset</source>
        <translation>Zapisz jako zestaw</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nazwa:</translation>
    </message>
    <message>
        <source>Saved as</source>
        <translation>Zapisano jako</translation>
    </message>
    <message>
        <source>Enter saves, Esc does not</source>
        <translation>Enter zapisuje, Esc nie</translation>
    </message>
    <message>
        <source>Everything as the scene says</source>
        <translation>Wszystko jak w scenie</translation>
    </message>
    <message>
        <source>Nothing was changed: there is nothing to save</source>
        <translation>Nic nie zmieniono: nie ma czego zapisać</translation>
    </message>
    <message>
        <source>Time stands still. Arrows or mouse tune, F2 goes on.</source>
        <translation>Czas stoi. Strzałki lub mysz stroją, F2 wraca do operacji.</translation>
    </message>
    <message>
        <source>No tuning in an exam</source>
        <translation>Podczas egzaminu nie ma strojenia</translation>
    </message>
    <message>
        <source>No sound on this computer</source>
        <translation>Brak dźwięku na tym komputerze</translation>
    </message>
    <message>
        <source>Sound off</source>
        <translation>Dźwięk wyłączony</translation>
    </message>
    <message>
        <source>Sound on</source>
        <translation>Dźwięk włączony</translation>
    </message>
    <message>
        <source>L wipes the lens</source>
        <translation>L przeciera optykę</translation>
    </message>
    <message>
        <source>Wipe the lens</source>
        <translation>Przetarcie optyki</translation>
    </message>
    <message>
        <source>One minute left</source>
        <translation>Została minuta</translation>
    </message>
    <message>
        <source>Ten seconds left</source>
        <translation>Zostało dziesięć sekund</translation>
    </message>
    <message>
        <source>Sound off, louder, softer</source>
        <translation>Dźwięk: wył., głośniej, ciszej</translation>
    </message>
    <message>
        <source>Clinician&apos;s tuning; does not count</source>
        <translation>Strojenie przez klinicystę; próba się nie liczy</translation>
    </message>
    <message>
        <source>Once something is changed, this attempt does not count.</source>
        <translation>Gdy coś zostanie zmienione, ta próba nie będzie się liczyć.</translation>
    </message>
    <message>
        <source>This attempt was tuned: it does not count.</source>
        <translation>Ta próba była strojona: nie liczy się.</translation>
    </message>
    <message>
        <source>Energy in air</source>
        <translation>Energia poza tkanką</translation>
    </message>
    <message>
        <source>Too long on one spot</source>
        <translation>Za długo w jednym miejscu</translation>
    </message>
    <message>
        <source>Too much force</source>
        <translation>Za duża siła</translation>
    </message>
    <message>
        <source>Tissue torn</source>
        <translation>Rozerwanie tkanki</translation>
    </message>
    <message>
        <source>COMPUTER TOO SLOW, does not count</source>
        <translation>KOMPUTER ZA WOLNY, nie liczy się</translation>
    </message>
    <message>
        <source>Grasp slips</source>
        <translation>Tkanka wysuwa się ze szczęk</translation>
    </message>
    <message>
        <source>Needle slips in the jaws</source>
        <translation>Igła ślizga się w szczękach</translation>
    </message>
    <message>
        <source>Needle turns in the jaws</source>
        <translation>Igła obraca się w szczękach</translation>
    </message>
    <message>
        <source>Needle dropped</source>
        <translation>Igła upuszczona</translation>
    </message>
    <message>
        <source>Thread cuts through tissue</source>
        <translation>Nić przecina tkankę</translation>
    </message>
    <message>
        <source>Thread torn out</source>
        <translation>Nić wyrwana z tkanki</translation>
    </message>
    <message>
        <source>Tissue crushed</source>
        <translation>Tkanka zmiażdżona</translation>
    </message>
    <message>
        <source>Pulled too hard</source>
        <translation>Za mocne pociąganie</translation>
    </message>
    <message>
        <source>No more cuts in this scene</source>
        <translation>Nie da się już ciąć w tej scenie</translation>
    </message>
    <message>
        <source>Placode cut</source>
        <translation>Płytka nacięta</translation>
    </message>
    <message>
        <source>Too close to the placode</source>
        <translation>Za blisko płytki</translation>
    </message>
    <message>
        <source>Energy out of view</source>
        <translation>Energia poza polem widzenia</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Zakończono</translation>
    </message>
    <message>
        <source>Move the instrument</source>
        <translation>Ruch narzędzia</translation>
    </message>
    <message>
        <source>Deeper, shallower</source>
        <translation>Głębiej, płycej</translation>
    </message>
    <message>
        <source>Shallower, deeper</source>
        <translation>Płycej, głębiej</translation>
    </message>
    <message>
        <source>Move the scope</source>
        <translation>Ruch fetoskopu</translation>
    </message>
    <message>
        <source>middle button</source>
        <translation>środkowy przycisk</translation>
    </message>
    <message>
        <source>Shift + mouse</source>
        <translation>Shift + mysz</translation>
    </message>
    <message>
        <source>Shift + wheel</source>
        <translation>Shift + kółko</translation>
    </message>
    <message>
        <source>The same, four times as far</source>
        <translation>To samo, czterokrotnie dalej</translation>
    </message>
    <message>
        <source>arrows</source>
        <translation>strzałki</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Spacja</translation>
    </message>
    <message>
        <source>left bumper</source>
        <translation>lewy przycisk górny</translation>
    </message>
    <message>
        <source>Turn about the shaft</source>
        <translation>Obrót wokół osi</translation>
    </message>
    <message>
        <source>Cut (yellow pedal)</source>
        <translation>Cięcie (żółty pedał)</translation>
    </message>
    <message>
        <source>Coagulate (blue pedal)</source>
        <translation>Koagulacja (niebieski pedał)</translation>
    </message>
    <message>
        <source>Precise</source>
        <translation>Precyzyjnie</translation>
    </message>
    <message>
        <source>Next instrument</source>
        <translation>Następne narzędzie</translation>
    </message>
    <message>
        <source>Hold the instrument still</source>
        <translation>Narzędzie stoi</translation>
    </message>
    <message>
        <source>Planned line on, off</source>
        <translation>Linia planowana wł., wył.</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>Wydajność</translation>
    </message>
    <message>
        <source>Screenshot</source>
        <translation>Zrzut ekranu</translation>
    </message>
    <message>
        <source>Pause and menu; lets the pointer out</source>
        <translation>Pauza i menu; uwalnia wskaźnik</translation>
    </message>
    <message>
        <source>hold Enter</source>
        <translation>przytrzymaj Enter</translation>
    </message>
    <message>
        <source>Finish and be scored</source>
        <translation>Zakończ i oceń</translation>
    </message>
    <message>
        <source>Pause, go on</source>
        <translation>Pauza, dalej</translation>
    </message>
    <message>
        <source>Space, Esc</source>
        <translation>Spacja, Esc</translation>
    </message>
    <message>
        <source>5 s back, 5 s on</source>
        <translation>5 s wstecz, 5 s dalej</translation>
    </message>
    <message>
        <source>Faster, slower</source>
        <translation>Szybciej, wolniej</translation>
    </message>
    <message>
        <source>Next camera</source>
        <translation>Następna kamera</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>Help on, off</source>
        <translation>Pomoc wł., wył.</translation>
    </message>
    <message>
        <source>Help; the clock stands still</source>
        <translation>Pomoc; zegar stoi</translation>
    </message>
    <message>
        <source>The clock stands still. Space, Enter or a click goes on.</source>
        <translation>Zegar stoi. Spacja, Enter lub kliknięcie: dalej.</translation>
    </message>
    <message>
        <source>mouse</source>
        <translation>mysz</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>kółko</translation>
    </message>
    <message>
        <source>left button</source>
        <translation>lewy przycisk</translation>
    </message>
    <message>
        <source>right button</source>
        <translation>prawy przycisk</translation>
    </message>
    <message>
        <source>left stick</source>
        <translation>lewa gałka</translation>
    </message>
    <message>
        <source>triggers</source>
        <translation>spusty</translation>
    </message>
    <message>
        <source>right stick</source>
        <translation>prawa gałka</translation>
    </message>
    <message>
        <source>arm</source>
        <translation>ramię</translation>
    </message>
    <message>
        <source>pedals</source>
        <translation>pedały</translation>
    </message>
    <message>
        <source>The simulated operator works by itself; watch.</source>
        <translation>Symulowany operator pracuje sam; patrz.</translation>
    </message>
    <message>
        <source>as operated</source>
        <translation>jak podczas próby</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>z góry</translation>
    </message>
    <message>
        <source>from the left</source>
        <translation>z lewej</translation>
    </message>
    <message>
        <source>from the feet</source>
        <translation>od strony stóp</translation>
    </message>
    <message>
        <source>near the tip</source>
        <translation>blisko końcówki</translation>
    </message>
    <message>
        <source>(computer: %1x)</source>
        <translation>(komputer: %1x)</translation>
    </message>
    <message>
        <source>simulating to %1</source>
        <translation>symulacja do %1</translation>
    </message>
    <message>
        <source>end of the recording</source>
        <translation>koniec zapisu</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>pauza</translation>
    </message>
    <message>
        <source>Left stick</source>
        <translation>Lewa gałka</translation>
    </message>
    <message>
        <source>Right stick</source>
        <translation>Prawa gałka</translation>
    </message>
    <message>
        <source>with the left stick</source>
        <translation>lewą gałką</translation>
    </message>
    <message>
        <source>with the right stick</source>
        <translation>prawą gałką</translation>
    </message>
    <message>
        <source>With the left stick</source>
        <translation>Lewą gałką</translation>
    </message>
    <message>
        <source>With the right stick</source>
        <translation>Prawą gałką</translation>
    </message>
    <message>
        <source>arrow keys</source>
        <translation>klawisze strzałek</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Klawisze strzałek</translation>
    </message>
</context>
<context>
    <name>Bilingual</name>
    <message>
        <source>Move the mouse. Ctrl makes it precise, Space holds the instrument still.</source>
        <translation>Ruszaj myszą. Ctrl: precyzyjnie, Spacja: narzędzie stoi.</translation>
    </message>
    <message>
        <source>W A S D. Ctrl makes it precise.</source>
        <translation>W A S D. Ctrl: precyzyjnie.</translation>
    </message>
    <message>
        <source>Left stick. The left bumper makes it precise.</source>
        <translation>Lewa gałka. Lewy przycisk górny: precyzyjnie.</translation>
    </message>
    <message>
        <source>Push the cap sideways, up and down.</source>
        <translation>Popychaj gałkę na boki, w górę i w dół.</translation>
    </message>
    <message>
        <source>Move the handle sideways. The tip goes the other way, as through a port.</source>
        <translation>Poruszaj uchwytem na boki. Końcówka idzie w przeciwną stronę, jak przez port.</translation>
    </message>
    <message>
        <source>Turn the wheel: away from you is deeper. Shift makes it quicker.</source>
        <translation>Kręć kółkiem: od siebie to głębiej. Shift: szybciej.</translation>
    </message>
    <message>
        <source>F goes deeper, R back.</source>
        <translation>F głębiej, R z powrotem.</translation>
    </message>
    <message>
        <source>Right trigger goes deeper, left trigger back.</source>
        <translation>Prawy spust głębiej, lewy z powrotem.</translation>
    </message>
    <message>
        <source>Push the cap away from you to go deeper, pull it to come back.</source>
        <translation>Popchnij gałkę od siebie, by wejść głębiej, pociągnij, by wrócić.</translation>
    </message>
    <message>
        <source>Push the handle in to go deeper, draw it out to come back.</source>
        <translation>Wsuń uchwyt, by wejść głębiej, wysuń, by wrócić.</translation>
    </message>
    <message>
        <source>Hold Shift and move the mouse sideways.</source>
        <translation>Przytrzymaj Shift i ruszaj myszą na boki.</translation>
    </message>
    <message>
        <source>Q and E turn.</source>
        <translation>Q i E obracają.</translation>
    </message>
    <message>
        <source>Right stick, sideways.</source>
        <translation>Prawa gałka, na boki.</translation>
    </message>
    <message>
        <source>Twist the cap.</source>
        <translation>Przekręcaj gałkę.</translation>
    </message>
    <message>
        <source>Turn the handle about its axis.</source>
        <translation>Obracaj uchwyt wokół osi.</translation>
    </message>
    <message>
        <source>Go above the ring, then down with the wheel, notch by notch. Ctrl makes notches small.</source>
        <translation>Ustaw się nad pierścieniem, potem w dół kółkiem, ząbek po ząbku. Ctrl: małe ząbki.</translation>
    </message>
    <message>
        <source>Go above the ring, then F with Ctrl.</source>
        <translation>Ustaw się nad pierścieniem, potem F z Ctrl.</translation>
    </message>
    <message>
        <source>Go above the ring, then the right trigger with the left bumper.</source>
        <translation>Ustaw się nad pierścieniem, potem prawy spust z lewym przyciskiem górnym.</translation>
    </message>
    <message>
        <source>Go above the ring, then push the cap gently away from you.</source>
        <translation>Ustaw się nad pierścieniem, potem delikatnie popchnij gałkę od siebie.</translation>
    </message>
    <message>
        <source>Go above the ring, then push the handle in until the tip touches.</source>
        <translation>Ustaw się nad pierścieniem, potem wsuwaj uchwyt, aż końcówka dotknie.</translation>
    </message>
    <message>
        <source>Touch the ring&apos;s middle, then hold the left button: yellow pedal, cut.</source>
        <translation>Dotknij środka pierścienia, potem przytrzymaj lewy przycisk: żółty pedał, cięcie.</translation>
    </message>
    <message>
        <source>Touch the ring&apos;s middle, then hold X: yellow pedal, cut.</source>
        <translation>Dotknij środka pierścienia, potem przytrzymaj X: żółty pedał, cięcie.</translation>
    </message>
    <message>
        <source>Touch the ring&apos;s middle, then hold A: yellow pedal, cut.</source>
        <translation>Dotknij środka pierścienia, potem przytrzymaj A: żółty pedał, cięcie.</translation>
    </message>
    <message>
        <source>Touch the ring&apos;s middle, then hold the left button or the yellow pedal: cut.</source>
        <translation>Dotknij środka pierścienia, potem przytrzymaj lewy przycisk lub żółty pedał: cięcie.</translation>
    </message>
    <message>
        <source>Touch the ring&apos;s middle, then press the yellow pedal: cut.</source>
        <translation>Dotknij środka pierścienia, potem naciśnij żółty pedał: cięcie.</translation>
    </message>
    <message>
        <source>Touch the ring&apos;s middle, then hold the right button: blue pedal, coagulation.</source>
        <translation>Dotknij środka pierścienia, potem przytrzymaj prawy przycisk: niebieski pedał, koagulacja.</translation>
    </message>
    <message>
        <source>Touch the ring&apos;s middle, then hold C: blue pedal, coagulation.</source>
        <translation>Dotknij środka pierścienia, potem przytrzymaj C: niebieski pedał, koagulacja.</translation>
    </message>
    <message>
        <source>Touch the ring&apos;s middle, then hold B: blue pedal, coagulation.</source>
        <translation>Dotknij środka pierścienia, potem przytrzymaj B: niebieski pedał, koagulacja.</translation>
    </message>
    <message>
        <source>Touch the ring&apos;s middle, then hold the right button or the blue pedal: coagulation.</source>
        <translation>Dotknij środka pierścienia, potem przytrzymaj prawy przycisk lub niebieski pedał: koagulacja.</translation>
    </message>
    <message>
        <source>Touch the ring&apos;s middle, then press the blue pedal: coagulation.</source>
        <translation>Dotknij środka pierścienia, potem naciśnij niebieski pedał: koagulacja.</translation>
    </message>
    <message>
        <source>Down until it touches, then hold the left button: the jaws close.</source>
        <translation>W dół, aż dotknie, potem przytrzymaj lewy przycisk: szczęki się zamkną.</translation>
    </message>
    <message>
        <source>Down until it touches, then hold X: the jaws close.</source>
        <translation>W dół, aż dotknie, potem przytrzymaj X: szczęki się zamkną.</translation>
    </message>
    <message>
        <source>Down until it touches, then hold A: the jaws close.</source>
        <translation>W dół, aż dotknie, potem przytrzymaj A: szczęki się zamkną.</translation>
    </message>
    <message>
        <source>Push in until it touches, then close the handle or hold its first button.</source>
        <translation>Wsuń, aż dotknie, potem zamknij uchwyt lub przytrzymaj jego pierwszy przycisk.</translation>
    </message>
    <message>
        <source>Let go of the left button.</source>
        <translation>Puść lewy przycisk.</translation>
    </message>
    <message>
        <source>Let go of X.</source>
        <translation>Puść X.</translation>
    </message>
    <message>
        <source>Let go of A.</source>
        <translation>Puść A.</translation>
    </message>
    <message>
        <source>Open the handle, or let go of its button.</source>
        <translation>Otwórz uchwyt lub puść jego przycisk.</translation>
    </message>
    <message>
        <source>Down with the wheel until the tip nearly touches, then follow the line with the mouse.</source>
        <translation>Kółkiem w dół, aż końcówka prawie dotknie, potem prowadź ją myszą wzdłuż linii.</translation>
    </message>
    <message>
        <source>F until the tip nearly touches, then W A S D with Ctrl along the line.</source>
        <translation>F, aż końcówka prawie dotknie, potem W A S D z Ctrl wzdłuż linii.</translation>
    </message>
    <message>
        <source>Right trigger until the tip nearly touches, then the left stick along the line.</source>
        <translation>Prawy spust, aż końcówka prawie dotknie, potem lewa gałka wzdłuż linii.</translation>
    </message>
    <message>
        <source>Push the cap away from you until the tip nearly touches, then sideways along the line.</source>
        <translation>Popchnij gałkę od siebie, aż końcówka prawie dotknie, potem na boki wzdłuż linii.</translation>
    </message>
    <message>
        <source>Push the handle in until the tip nearly touches, then follow the line.</source>
        <translation>Wsuń uchwyt, aż końcówka prawie dotknie, potem prowadź ją wzdłuż linii.</translation>
    </message>
    <message>
        <source>Hold the left button to grasp, Tab keeps it held; grasp with the other hand, then pull gently.</source>
        <translation>Przytrzymaj lewy przycisk, by chwycić, Tab zostawia chwyt; chwyć drugą ręką i delikatnie ciągnij.</translation>
    </message>
    <message>
        <source>Hold X to grasp, Tab keeps it held; grasp with the other hand, then pull gently with Ctrl.</source>
        <translation>Przytrzymaj X, by chwycić, Tab zostawia chwyt; chwyć drugą ręką i delikatnie ciągnij z Ctrl.</translation>
    </message>
    <message>
        <source>Hold A to grasp, Tab on the keyboard keeps it held; grasp with the other hand, then pull gently.</source>
        <translation>Przytrzymaj A, by chwycić, Tab na klawiaturze zostawia chwyt; chwyć drugą ręką i delikatnie ciągnij.</translation>
    </message>
    <message>
        <source>Hold the left button to grasp, Tab on the keyboard keeps it held; grasp with the other hand, then pull gently.</source>
        <translation>Przytrzymaj lewy przycisk, by chwycić, Tab na klawiaturze zostawia chwyt; chwyć drugą ręką i delikatnie ciągnij.</translation>
    </message>
    <message>
        <source>Grasp with both hands, then pull gently until both bars stand in the green band.</source>
        <translation>Chwyć obiema rękami, potem delikatnie ciągnij, aż oba paski staną w zielonym polu.</translation>
    </message>
    <message>
        <source>Wheel towards you.</source>
        <translation>Kółko do siebie.</translation>
    </message>
    <message>
        <source>R draws back.</source>
        <translation>R cofa.</translation>
    </message>
    <message>
        <source>Left trigger draws back.</source>
        <translation>Lewy spust cofa.</translation>
    </message>
    <message>
        <source>Pull the cap towards you.</source>
        <translation>Pociągnij gałkę do siebie.</translation>
    </message>
    <message>
        <source>Draw the handle out.</source>
        <translation>Wysuń uchwyt.</translation>
    </message>
    <message>
        <source>Mouse and wheel bring the point over the mark; Shift and mouse sideways turn it in.</source>
        <translation>Mysz i kółko ustawiają ostrze nad znakiem; Shift i mysz na boki wkłuwają je obrotem.</translation>
    </message>
    <message>
        <source>W A S D, F and R bring the point over the mark; Q and E turn it in.</source>
        <translation>W A S D, F i R ustawiają ostrze nad znakiem; Q i E wkłuwają je obrotem.</translation>
    </message>
    <message>
        <source>Left stick and triggers bring the point over the mark; the right stick turns it in.</source>
        <translation>Lewa gałka i spusty ustawiają ostrze nad znakiem; prawa gałka wkłuwa je obrotem.</translation>
    </message>
    <message>
        <source>Push the cap until the point stands over the mark; twist it to turn the needle in.</source>
        <translation>Popychaj gałkę, aż ostrze stanie nad znakiem; skręć ją, by wkłuć igłę obrotem.</translation>
    </message>
    <message>
        <source>Bring the point over the mark, then turn the handle about its axis.</source>
        <translation>Ustaw ostrze nad znakiem, potem obracaj uchwyt wokół osi.</translation>
    </message>
    <message>
        <source>Go on turning with Shift and the mouse until the point comes out.</source>
        <translation>Obracaj dalej z Shift i myszą, aż ostrze wyjdzie.</translation>
    </message>
    <message>
        <source>Keep the needle held; mouse and wheel bring its point to the ring, Shift and mouse turn it.</source>
        <translation>Nie puszczaj igły; mysz i kółko prowadzą jej ostrze do pierścienia, Shift i mysz ją obracają.</translation>
    </message>
    <message>
        <source>Keep the needle held; W A S D, F and R bring its point to the ring, Q and E turn it.</source>
        <translation>Nie puszczaj igły; W A S D, F i R prowadzą jej ostrze do pierścienia, Q i E ją obracają.</translation>
    </message>
    <message>
        <source>Keep the needle held; left stick and triggers bring its point to the ring, the right stick turns it.</source>
        <translation>Nie puszczaj igły; lewa gałka i spusty prowadzą jej ostrze do pierścienia, prawa gałka ją obraca.</translation>
    </message>
    <message>
        <source>Keep the needle held; push the cap until its point is at the ring, twist to turn it.</source>
        <translation>Nie puszczaj igły; popychaj gałkę, aż ostrze będzie przy pierścieniu, skręć, by ją obrócić.</translation>
    </message>
    <message>
        <source>Keep it closed; bring the needle's point to the ring, turn the handle about its axis.</source>
        <translation>Trzymaj zamknięte; doprowadź ostrze igły do pierścienia, obracaj uchwyt wokół osi.</translation>
    </message>
    <message>
        <source>Lower the needle over the ring with the wheel until it lies there, then press and let go of the left button.</source>
        <translation>Opuść igłę kółkiem, aż będzie leżeć przy pierścieniu, potem naciśnij i puść lewy przycisk.</translation>
    </message>
    <message>
        <source>Lower the needle over the ring with F until it lies there, then press and let go of X.</source>
        <translation>Opuść igłę klawiszem F, aż będzie leżeć przy pierścieniu, potem naciśnij i puść X.</translation>
    </message>
    <message>
        <source>Lower the needle over the ring with the right trigger until it lies there, then press and let go of A.</source>
        <translation>Opuść igłę prawym spustem, aż będzie leżeć przy pierścieniu, potem naciśnij i puść A.</translation>
    </message>
    <message>
        <source>Push the cap until the needle lies at the ring, then press and let go of the left button.</source>
        <translation>Popychaj gałkę, aż igła będzie leżeć przy pierścieniu, potem naciśnij i puść lewy przycisk.</translation>
    </message>
    <message>
        <source>Lower the needle until it lies at the ring, then open the handle.</source>
        <translation>Opuść igłę, aż będzie leżeć przy pierścieniu, potem otwórz uchwyt.</translation>
    </message>
    <message>
        <source>Go on turning with Q or E until the point comes out.</source>
        <translation>Obracaj dalej klawiszem Q lub E, aż ostrze wyjdzie.</translation>
    </message>
    <message>
        <source>Go on turning with the right stick until the point comes out.</source>
        <translation>Obracaj dalej prawą gałką, aż ostrze wyjdzie.</translation>
    </message>
    <message>
        <source>Go on twisting the cap until the point comes out.</source>
        <translation>Skręcaj dalej gałkę, aż ostrze wyjdzie.</translation>
    </message>
    <message>
        <source>Go on turning the handle until the point comes out.</source>
        <translation>Obracaj dalej uchwyt, aż ostrze wyjdzie.</translation>
    </message>
    <message>
        <source>Press and let go of the left button, go over the needle behind its point, hold the button.</source>
        <translation>Naciśnij i puść lewy przycisk, najedź na igłę za ostrzem i przytrzymaj przycisk.</translation>
    </message>
    <message>
        <source>Press and let go of X, go over the needle behind its point, hold X.</source>
        <translation>Naciśnij i puść X, najedź na igłę za ostrzem i przytrzymaj X.</translation>
    </message>
    <message>
        <source>Press and let go of A, go over the needle behind its point, hold A.</source>
        <translation>Naciśnij i puść A, najedź na igłę za ostrzem i przytrzymaj A.</translation>
    </message>
    <message>
        <source>Press and let go of the left button, go over the needle behind its point, hold it again.</source>
        <translation>Naciśnij i puść lewy przycisk, najedź na igłę za ostrzem i znów go przytrzymaj.</translation>
    </message>
    <message>
        <source>Turn with Shift and the mouse; press and let go of the left button, go to the ring, hold the button.</source>
        <translation>Obracaj z Shift i myszą; naciśnij i puść lewy przycisk, najedź na pierścień, przytrzymaj przycisk.</translation>
    </message>
    <message>
        <source>Turn with Q or E; press and let go of X, go to the ring, hold X.</source>
        <translation>Obracaj klawiszem Q lub E; naciśnij i puść X, najedź na pierścień, przytrzymaj X.</translation>
    </message>
    <message>
        <source>Turn with the right stick; press and let go of A, go to the ring, hold A.</source>
        <translation>Obracaj prawą gałką; naciśnij i puść A, najedź na pierścień, przytrzymaj A.</translation>
    </message>
    <message>
        <source>Twist the cap to turn; press and let go of the left button, go to the ring, hold it again.</source>
        <translation>Skręcaj gałkę, by obracać; naciśnij i puść lewy przycisk, najedź na pierścień, znów go przytrzymaj.</translation>
    </message>
    <message>
        <source>Turn the handle; open it, go to the ring, and close it.</source>
        <translation>Obracaj uchwyt; otwórz go, najedź na pierścień i zamknij.</translation>
    </message>
    <message>
        <source>Press and let go of the left button: the jaws open.</source>
        <translation>Naciśnij i puść lewy przycisk: szczęki się otworzą.</translation>
    </message>
    <message>
        <source>Press and let go of X: the jaws open.</source>
        <translation>Naciśnij i puść X: szczęki się otworzą.</translation>
    </message>
    <message>
        <source>Press and let go of A: the jaws open.</source>
        <translation>Naciśnij i puść A: szczęki się otworzą.</translation>
    </message>
    <message>
        <source>Lift the edge by 2 mm with the wheel, then Tab with the button down.</source>
        <translation>Unieś brzeg kółkiem o 2 mm, potem Tab przy wciśniętym przycisku.</translation>
    </message>
    <message>
        <source>Lift the edge by 2 mm with R, then Tab with X down.</source>
        <translation>Unieś brzeg klawiszem R o 2 mm, potem Tab przy wciśniętym X.</translation>
    </message>
    <message>
        <source>Lift the edge by 2 mm with the left trigger, then Tab on the keyboard with A down.</source>
        <translation>Unieś brzeg lewym spustem o 2 mm, potem Tab na klawiaturze przy wciśniętym A.</translation>
    </message>
    <message>
        <source>Lift the edge by 2 mm with the cap, then Tab on the keyboard with the button down.</source>
        <translation>Unieś brzeg gałką o 2 mm, potem Tab na klawiaturze przy wciśniętym przycisku.</translation>
    </message>
    <message>
        <source>Lift the edge by 2 mm and keep it. With one arm: tap its second button to change hands.</source>
        <translation>Unieś brzeg o 2 mm i trzymaj. Jedno ramię: jego drugi przycisk zmienia rękę.</translation>
    </message>
    <message>
        <source>Open the handle, go over the needle behind its point, and close it.</source>
        <translation>Otwórz uchwyt, najedź na igłę za ostrzem i zamknij go.</translation>
    </message>
    <message>
        <source>Hold the left button and turn with Shift and the mouse, round the needle&apos;s own circle.</source>
        <translation>Trzymaj lewy przycisk i obracaj z Shift i myszą, po okręgu igły.</translation>
    </message>
    <message>
        <source>Hold X and turn with Q or E, round the needle&apos;s own circle.</source>
        <translation>Trzymaj X i obracaj klawiszem Q lub E, po okręgu igły.</translation>
    </message>
    <message>
        <source>Hold A and turn with the right stick, round the needle&apos;s own circle.</source>
        <translation>Trzymaj A i obracaj prawą gałką, po okręgu igły.</translation>
    </message>
    <message>
        <source>Hold the left button and twist the cap, round the needle&apos;s own circle.</source>
        <translation>Trzymaj lewy przycisk i skręcaj gałkę, po okręgu igły.</translation>
    </message>
    <message>
        <source>Keep it closed and turn the handle, round the needle&apos;s own circle.</source>
        <translation>Trzymaj zamknięty i obracaj uchwyt, po okręgu igły.</translation>
    </message>
    <message>
        <source>Hold the left button and draw back with the wheel, towards you; go slowly once it is taut.</source>
        <translation>Trzymaj lewy przycisk i ciągnij kółkiem do siebie; powoli, gdy nić się napnie.</translation>
    </message>
    <message>
        <source>Hold X and draw back with R; with Ctrl once it is taut.</source>
        <translation>Trzymaj X i ciągnij klawiszem R; z Ctrl, gdy nić się napnie.</translation>
    </message>
    <message>
        <source>Hold A and draw back with the left trigger; go slowly once it is taut.</source>
        <translation>Trzymaj A i ciągnij lewym spustem; powoli, gdy nić się napnie.</translation>
    </message>
    <message>
        <source>Hold the left button and pull the cap towards you; go slowly once it is taut.</source>
        <translation>Trzymaj lewy przycisk i ciągnij gałkę do siebie; powoli, gdy nić się napnie.</translation>
    </message>
    <message>
        <source>Keep it closed and draw the handle out; go slowly once you feel the thread.</source>
        <translation>Trzymaj zamknięty i wysuwaj uchwyt; powoli, gdy poczujesz nić.</translation>
    </message>
    <message>
        <source>Down with the wheel at the ring until the jaws touch, then hold the left button.</source>
        <translation>Kółkiem w dół przy pierścieniu, aż szczęki dotkną, potem przytrzymaj lewy przycisk.</translation>
    </message>
    <message>
        <source>F at the ring until the jaws touch, then hold X.</source>
        <translation>F przy pierścieniu, aż szczęki dotkną, potem przytrzymaj X.</translation>
    </message>
    <message>
        <source>Right trigger at the ring until the jaws touch, then hold A.</source>
        <translation>Prawy spust przy pierścieniu, aż szczęki dotkną, potem przytrzymaj A.</translation>
    </message>
    <message>
        <source>Push the cap at the ring until the jaws touch, then hold the left button.</source>
        <translation>Popchnij gałkę przy pierścieniu, aż szczęki dotkną, potem przytrzymaj lewy przycisk.</translation>
    </message>
    <message>
        <source>Push the handle in at the ring until the jaws touch, then close it.</source>
        <translation>Wsuń uchwyt przy pierścieniu, aż szczęki dotkną, potem go zamknij.</translation>
    </message>
    <message>
        <source>Keep the left button down, lift a little with the wheel, draw it over with the mouse, lower it.</source>
        <translation>Trzymaj lewy przycisk, unieś trochę kółkiem, przeciągnij myszą na miejsce, opuść.</translation>
    </message>
    <message>
        <source>Keep X down, lift a little with R, draw it over with W A S D, lower it with F.</source>
        <translation>Trzymaj X, unieś trochę klawiszem R, przeciągnij W A S D na miejsce, opuść klawiszem F.</translation>
    </message>
    <message>
        <source>Keep A down, lift a little with the left trigger, draw it over with the left stick, lower it.</source>
        <translation>Trzymaj A, unieś trochę lewym spustem, przeciągnij lewą gałką na miejsce, opuść.</translation>
    </message>
    <message>
        <source>Keep the left button down, lift a little with the cap, draw it over sideways, lower it.</source>
        <translation>Trzymaj lewy przycisk, unieś trochę gałką, przeciągnij w bok na miejsce, opuść.</translation>
    </message>
    <message>
        <source>Keep it closed, lift a little, draw it over its place, lower it.</source>
        <translation>Trzymaj zamknięty, unieś trochę, przeciągnij na miejsce, opuść.</translation>
    </message>
    <message>
        <source>Let go of the left button; where a fold is, take its rim again and draw it outwards.</source>
        <translation>Puść lewy przycisk; gdzie jest fałda, chwyć znów brzeg i pociągnij go na zewnątrz.</translation>
    </message>
    <message>
        <source>Let go of X; where a fold is, take its rim again and draw it outwards.</source>
        <translation>Puść X; gdzie jest fałda, chwyć znów brzeg i pociągnij go na zewnątrz.</translation>
    </message>
    <message>
        <source>Let go of A; where a fold is, take its rim again and draw it outwards.</source>
        <translation>Puść A; gdzie jest fałda, chwyć znów brzeg i pociągnij go na zewnątrz.</translation>
    </message>
    <message>
        <source>Open the handle; where a fold is, take its rim again and draw it outwards.</source>
        <translation>Otwórz uchwyt; gdzie jest fałda, chwyć znów brzeg i pociągnij go na zewnątrz.</translation>
    </message>
    <message>
        <source>Stay 1 cm above, point the jet beside the ring, hold the left button: water.</source>
        <translation>Zostań 1 cm nad polem, skieruj strumień obok pierścienia, przytrzymaj lewy przycisk: woda.</translation>
    </message>
    <message>
        <source>Stay 1 cm above, point the jet beside the ring, hold X: water.</source>
        <translation>Zostań 1 cm nad polem, skieruj strumień obok pierścienia, przytrzymaj X: woda.</translation>
    </message>
    <message>
        <source>Stay 1 cm above, point the jet beside the ring, hold A: water.</source>
        <translation>Zostań 1 cm nad polem, skieruj strumień obok pierścienia, przytrzymaj A: woda.</translation>
    </message>
    <message>
        <source>Stay 1 cm above, point the jet beside the ring, press the yellow pedal: water.</source>
        <translation>Zostań 1 cm nad polem, skieruj strumień obok pierścienia, naciśnij żółty pedał: woda.</translation>
    </message>
    <message>
        <source>Down with the wheel into the fluid at the ring, not onto tissue; hold the right button.</source>
        <translation>Kółkiem w dół do płynu przy pierścieniu, nie na tkankę; przytrzymaj prawy przycisk.</translation>
    </message>
    <message>
        <source>F down into the fluid at the ring, not onto tissue; hold C.</source>
        <translation>F w dół do płynu przy pierścieniu, nie na tkankę; przytrzymaj C.</translation>
    </message>
    <message>
        <source>Right trigger down into the fluid at the ring, not onto tissue; hold B.</source>
        <translation>Prawy spust w dół do płynu przy pierścieniu, nie na tkankę; przytrzymaj B.</translation>
    </message>
    <message>
        <source>Push the cap down into the fluid at the ring, not onto tissue; hold the right button.</source>
        <translation>Popchnij gałkę w dół do płynu przy pierścieniu, nie na tkankę; przytrzymaj prawy przycisk.</translation>
    </message>
    <message>
        <source>Down into the fluid at the ring, not onto tissue; press the blue pedal.</source>
        <translation>W dół do płynu przy pierścieniu, nie na tkankę; naciśnij niebieski pedał.</translation>
    </message>
    <message>
        <source>Left button down, in below the lifted edge, raise the tip by 2 mm with the wheel; deeper.</source>
        <translation>Lewy przycisk, wejdź pod uniesiony brzeg, unieś końcówkę kółkiem o 2 mm; potem głębiej.</translation>
    </message>
    <message>
        <source>Hold X, in below the lifted edge, raise the tip by 2 mm with R, F down; deeper.</source>
        <translation>Trzymaj X, wejdź pod uniesiony brzeg, R unosi końcówkę o 2 mm, F opuszcza; potem głębiej.</translation>
    </message>
    <message>
        <source>Hold A, in below the lifted edge, raise the tip by 2 mm with the left trigger; deeper.</source>
        <translation>Trzymaj A, wejdź pod uniesiony brzeg, unieś końcówkę o 2 mm lewym spustem; potem głębiej.</translation>
    </message>
    <message>
        <source>Left button down, in below the lifted edge, raise the tip by 2 mm with the cap; deeper.</source>
        <translation>Lewy przycisk, wejdź pod uniesiony brzeg, unieś końcówkę gałką o 2 mm; potem głębiej.</translation>
    </message>
    <message>
        <source>Closed, in below the lifted edge; raise the tip and open a little, 2 mm; then deeper.</source>
        <translation>Zamknięty wejdź pod uniesiony brzeg; unieś końcówkę o 2 mm, trochę otwierając; potem głębiej.</translation>
    </message>
    <message>
        <source>Hold the middle button and move the mouse.</source>
        <translation>Przytrzymaj środkowy przycisk i ruszaj myszą.</translation>
    </message>
    <message>
        <source>Arrow keys.</source>
        <translation>Klawisze strzałek.</translation>
    </message>
    <message>
        <source>Tab changes hands.</source>
        <translation>Tab zmienia rękę.</translation>
    </message>
    <message>
        <source>Tab on the keyboard changes hands.</source>
        <translation>Tab na klawiaturze zmienia rękę.</translation>
    </message>
    <message>
        <source>With one arm: tap its second button to change hands.</source>
        <translation>Jedno ramię: jego drugi przycisk zmienia rękę.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was mastered, but not repeated since; from %2 the skill fades. Reach %3 points once more.</source>
        <translation>„%1” zaliczono, ale od tego czasu nie powtarzano; od %2 umiejętność słabnie. Osiągnij jeszcze raz %3 pkt.</translation>
    </message>
    <message>
        <source>Get to know instruments and field with &quot;%1&quot;; any finished attempt counts.</source>
        <translation>Poznaj narzędzia i pole w zadaniu „%1”; liczy się każda ukończona próba.</translation>
    </message>
    <message>
        <source>The last attempt had a critical error, so the count begins again.</source>
        <translation>W ostatniej próbie był błąd krytyczny, więc liczenie zaczyna się od nowa.</translation>
    </message>
    <message>
        <source>Best so far: %1 of the %2 points needed.</source>
        <translation>Najlepszy wynik: %1 z potrzebnych %2 pkt.</translation>
    </message>
    <message>
        <source>Exam, attempt %1: &quot;%2&quot; without aids, case %3, %4 points.</source>
        <translation>Egzamin, próba %1: „%2” bez pomocy, przypadek %3, %4 pkt.</translation>
    </message>
    <message>
        <source>A proctor has to be present.</source>
        <translation>Musi być obecna osoba nadzorująca.</translation>
    </message>
    <message>
        <source>All stages are mastered.</source>
        <translation>Wszystkie etapy są zaliczone.</translation>
    </message>
    <message>
        <source>The next repetition is due on %1.</source>
        <translation>Najbliższe powtórzenie: %1.</translation>
    </message>
    <message>
        <source>All %1 attempts at &quot;%2&quot; are used; ask an educator for more.</source>
        <translation>Wykorzystano wszystkie próby (%1) w zadaniu „%2”; poproś osobę prowadzącą o następne.</translation>
    </message>
    <message>
        <source>Nothing is open.</source>
        <translation>Nic nie jest otwarte.</translation>
    </message>
    <message>
        <source>The course was due on %1.</source>
        <translation>Termin kursu minął %1.</translation>
    </message>
    <message>
        <source>The course is due on %1.</source>
        <translation>Termin kursu: %1.</translation>
    </message>
    <message>
        <source>The course begins on %1.</source>
        <translation>Kurs zaczyna się %1.</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Zaświadczenie</translation>
    </message>
    <message>
        <source>This is to certify that</source>
        <translation>Niniejszym zaświadcza się, że</translation>
    </message>
    <message>
        <source>has mastered all %1 stages of the course</source>
        <translation>zalicza wszystkie etapy kursu (%1)</translation>
    </message>
    <message>
        <source>version %1, mastered on %2, issued on %3, code %4</source>
        <translation>wersja %1, zaliczono %2, wydano %3, kod %4</translation>
    </message>
    <message>
        <source>Mastery in simulation by the rules of this course version; not a licence to operate.</source>
        <translation>Zaliczenie w symulacji według zasad tej wersji kursu; nie jest uprawnieniem do operowania.</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) is (are) left.</source>
        <translation>
            <numerusform>Pozostało: %n próba.</numerusform>
            <numerusform>Pozostało: %n próby.</numerusform>
            <numerusform>Pozostało: %n prób.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>&quot;%1&quot; is your next stage: no attempt of yours counts there yet. To master it, reach at least %2 points, %n time(s) in a row.</source>
        <translation>
            <numerusform>„%1” to Twój następny etap: nie liczy się w nim jeszcze żadna Twoja próba. Aby go zaliczyć, zdobądź co najmniej %2 pkt, jeden raz.</numerusform>
            <numerusform>„%1” to Twój następny etap: nie liczy się w nim jeszcze żadna Twoja próba. Aby go zaliczyć, zdobądź co najmniej %2 pkt, %n razy z rzędu.</numerusform>
            <numerusform>„%1” to Twój następny etap: nie liczy się w nim jeszcze żadna Twoja próba. Aby go zaliczyć, zdobądź co najmniej %2 pkt, %n razy z rzędu.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>&quot;%1&quot; needs %n more attempt(s) in a row at %2 points or above.</source>
        <translation>
            <numerusform>Do zaliczenia „%1” brakuje jeszcze: %n próba na %2 pkt lub wyżej.</numerusform>
            <numerusform>Do zaliczenia „%1” brakuje jeszcze: %n próby z rzędu na %2 pkt lub wyżej.</numerusform>
            <numerusform>Do zaliczenia „%1” brakuje jeszcze: %n prób z rzędu na %2 pkt lub wyżej.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>What is recorded of you in this study is kept for %n year(s) after your last step, and then erased.</source>
        <translation>
            <numerusform>To, co zapisano o Tobie w tym badaniu, przechowuje się przez %n rok od Twojego ostatniego kroku, a potem usuwa.</numerusform>
            <numerusform>To, co zapisano o Tobie w tym badaniu, przechowuje się przez %n lata od Twojego ostatniego kroku, a potem usuwa.</numerusform>
            <numerusform>To, co zapisano o Tobie w tym badaniu, przechowuje się przez %n lat od Twojego ostatniego kroku, a potem usuwa.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Key</name>
    <message>
        <source>Space</source>
        <translation>Spacja</translation>
    </message>
</context>
<context>
    <name>placode::ui::WaitingRecordings</name>
    <message>
        <source>Saving the attempt</source>
        <translation>Zapis próby</translation>
    </message>
</context>
<context>
    <name>CopiesLeft</name>
    <message>
        <source>Backups of the server may still hold the data of %1; ask its administrator.</source>
        <translation>Kopie zapasowe serwera mogą jeszcze zawierać usunięte dane (%1); zapytaj administratora serwera.</translation>
    </message>
    <message>
        <source>These copies may still hold the data of %1. A restore erases them again; delete the copies that you do not need:</source>
        <translation>Te kopie mogą jeszcze zawierać usunięte dane (%1). Przywrócenie usunie je ponownie; usuń kopie, których nie potrzebujesz:</translation>
    </message>
</context>
</TS>
