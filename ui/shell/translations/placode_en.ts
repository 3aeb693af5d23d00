<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_GB" sourcelanguage="en_GB">
<context>
    <name>ProtocolCard</name>
    <message numerus="yes">
        <source>%n file(s), read back and compared with the store: %1</source>
        <translation>
            <numerusform>%n file, read back and compared with the store: %1</numerusform>
            <numerusform>%n files, read back and compared with the store: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ParticipantPage</name>
    <message numerus="yes">
        <source>%n year(s)</source>
        <translation>
            <numerusform>%n year</numerusform>
            <numerusform>%n years</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RetentionCard</name>
    <message numerus="yes">
        <source>Erase the records of %n participant(s)?</source>
        <translation>
            <numerusform>Erase the records of %n participant?</numerusform>
            <numerusform>Erase the records of %n participants?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The records of %n participant(s) are erased.</source>
        <translation>
            <numerusform>The records of %n participant are erased.</numerusform>
            <numerusform>The records of %n participants are erased.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Participants were told: %n year(s) after their last step.</source>
        <translation>
            <numerusform>Participants were told: %n year after their last step.</numerusform>
            <numerusform>Participants were told: %n years after their last step.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The time of %n participant(s) is over: %1.</source>
        <translation>
            <numerusform>The time of %n participant is over: %1.</numerusform>
            <numerusform>The time of %n participants is over: %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StudiesPage</name>
    <message numerus="yes">
        <source>%n file(s), read back and compared with the store: %1</source>
        <translation>
            <numerusform>%n file, read back and compared with the store: %1</numerusform>
            <numerusform>%n files, read back and compared with the store: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StudyResultsPage</name>
    <message numerus="yes">
        <source>%n file(s) written: %1</source>
        <translation>
            <numerusform>%n file written: %1</numerusform>
            <numerusform>%n files written: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ResultPage</name>
    <message numerus="yes">
        <source>before: mean of the last %n attempt(s)</source>
        <translation>
            <numerusform>before: the last attempt</numerusform>
            <numerusform>before: mean of the last %n attempts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Own band: mean and standard deviation of your last %n attempt(s) before this one; the dot is this attempt.</source>
        <translation>
            <numerusform>Own band: your last attempt before this one; the dot is this attempt.</numerusform>
            <numerusform>Own band: mean and standard deviation of your last %n attempts before this one; the dot is this attempt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>LedgerView</name>
    <message numerus="yes">
        <source>%n entry(s). Arrow keys go from one to the next.</source>
        <translation>
            <numerusform>%n entry. Arrow keys go from one to the next.</numerusform>
            <numerusform>%n entries. Arrow keys go from one to the next.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>CohortPage</name>
    <message numerus="yes">
        <source>First, last and best score of %n person(s).</source>
        <translation>
            <numerusform>First, last and best score of %n person.</numerusform>
            <numerusform>First, last and best score of %n people.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StandardsPage</name>
    <message numerus="yes">
        <source>From the estimates of %n judge(s), standard error %1 points. %2</source>
        <translation>
            <numerusform>From the estimate of %n judge, standard error %1 points. %2</numerusform>
            <numerusform>From the estimates of %n judges, standard error %1 points. %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>CourseWords</name>
    <message numerus="yes">
        <source>%n fixed case(s), one after the other, then from the first</source>
        <translation>
            <numerusform>%n fixed case</numerusform>
            <numerusform>%n fixed cases, one after the other, then from the first</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Benchmark %n point(s), once</source>
        <translation>
            <numerusform>Benchmark %n point, once</numerusform>
            <numerusform>Benchmark %n points, once</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Benchmark %n point(s), %1 times in a row</source>
        <translation>
            <numerusform>Benchmark %n point, %1 times in a row</numerusform>
            <numerusform>Benchmark %n points, %1 times in a row</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>to be refreshed after %n day(s)</source>
        <translation>
            <numerusform>to be refreshed after %n day</numerusform>
            <numerusform>to be refreshed after %n days</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) are fewer than what is wanted in a row: it could never be mastered.</source>
        <translation>
            <numerusform>%n attempt is fewer than what is wanted in a row: it could never be mastered.</numerusform>
            <numerusform>%n attempts are fewer than what is wanted in a row: it could never be mastered.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Deviation</name>
    <message numerus="yes">
        <source>The computer was too slow: %n picture(s) a second, 20 are needed</source>
        <translation>
            <numerusform>The computer was too slow: %n picture a second, 20 are needed</numerusform>
            <numerusform>The computer was too slow: %n pictures a second, 20 are needed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>TodayPage</name>
    <message numerus="yes">
        <source>%n new remark(s) from your educator</source>
        <translation>
            <numerusform>%n new remark from your educator</numerusform>
            <numerusform>%n new remarks from your educator</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Parts</name>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Web</name>
    <message numerus="yes">
        <source>%n attempt(s), newest first</source>
        <translation>
            <numerusform>%n attempt, newest first</numerusform>
            <numerusform>%n attempts, newest first</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entry(ies) of the damage ledger</source>
        <translation>
            <numerusform>%n entry of the damage ledger</numerusform>
            <numerusform>%n entries of the damage ledger</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n person(s) with attempts</source>
        <translation>
            <numerusform>%n person with attempts</numerusform>
            <numerusform>%n people with attempts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n person(s) and task(s) passed once and not practised since, the longest first</source>
        <translation>
            <numerusform>%n person and task passed once and not practised since, the longest first</numerusform>
            <numerusform>%n people and tasks passed once and not practised since, the longest first</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n person(s). Every point is a person; box: quartiles, line: median, diamond: mean.</source>
        <translation>
            <numerusform>%n person. Every point is a person; box: quartiles, line: median, diamond: mean.</numerusform>
            <numerusform>%n people. Every point is a person; box: quartiles, line: median, diamond: mean.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>All of them: %n attempt(s)</source>
        <translation>
            <numerusform>All of them: %n attempt</numerusform>
            <numerusform>All of them: %n attempts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s), last %1, best %2, pass mark %3</source>
        <translation>
            <numerusform>%n attempt, last %1, best %2, pass mark %3</numerusform>
            <numerusform>%n attempts, last %1, best %2, pass mark %3</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n account(s)</source>
        <translation>
            <numerusform>%n account</numerusform>
            <numerusform>%n accounts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n judge(s), standard error %1</source>
        <translation>
            <numerusform>%n judge, standard error %1</numerusform>
            <numerusform>%n judges, standard error %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n person(s)</source>
        <translation>
            <numerusform>%1: %n person</numerusform>
            <numerusform>%1: %n people</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, %n attempt(s)</source>
        <translation>
            <numerusform>%1, %n attempt</numerusform>
            <numerusform>%1, %n attempts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s) was (were) typed a second time.</source>
        <translation>
            <numerusform>%n sheet was typed a second time.</numerusform>
            <numerusform>%n sheets were typed a second time.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n open difference(s)</source>
        <translation>
            <numerusform>%n open difference</numerusform>
            <numerusform>%n open differences</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n deviation(s) or note(s)</source>
        <translation>
            <numerusform>%n deviation or note</numerusform>
            <numerusform>%n deviations and notes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Bilingual</name>
    <message numerus="yes">
        <source>%n attempt(s) is (are) left.</source>
        <translation>
            <numerusform>%n attempt is left.</numerusform>
            <numerusform>%n attempts are left.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>&quot;%1&quot; is your next stage: no attempt of yours counts there yet. To master it, reach at least %2 points, %n time(s) in a row.</source>
        <translation>
            <numerusform>&quot;%1&quot; is your next stage: no attempt of yours counts there yet. To master it, reach at least %2 points, once.</numerusform>
            <numerusform>&quot;%1&quot; is your next stage: no attempt of yours counts there yet. To master it, reach at least %2 points, %n times in a row.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>&quot;%1&quot; needs %n more attempt(s) in a row at %2 points or above.</source>
        <translation>
            <numerusform>&quot;%1&quot; needs %n more attempt at %2 points or above.</numerusform>
            <numerusform>&quot;%1&quot; needs %n more in a row at %2 points or above.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>What is recorded of you in this study is kept for %n year(s) after your last step, and then erased.</source>
        <translation>
            <numerusform>What is recorded of you in this study is kept for %n year after your last step, and then erased.</numerusform>
            <numerusform>What is recorded of you in this study is kept for %n years after your last step, and then erased.</numerusform>
        </translation>
    </message>
</context>
</TS>
