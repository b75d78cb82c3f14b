<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="it" sourcelanguage="en">
<context>
    <name>FYD</name>
    <message>
        <source> STOP   Esc</source>
        <translation> STOP   Esc</translation>
    </message>
    <message>
        <source> UTC</source>
        <translation> UTC</translation>
    </message>
    <message>
        <source> curves</source>
        <translation> curve</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>% of target</source>
        <translation>% dell'obiettivo</translation>
    </message>
    <message>
        <source>%1
%2</source>
        <translation>%1
%2</translation>
    </message>
    <message>
        <source>%1   (%2)</source>
        <translation>%1   (%2)</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 (%2 times)</source>
        <translation>%1 (%2 volte)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 (not there any more)</source>
        <translation>%1 (non c'è più)</translation>
    </message>
    <message>
        <source>%1 / %2 N/mm</source>
        <translation>%1 / %2 N/mm</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1 GB</translation>
    </message>
    <message>
        <source>%1 Hold still, take the point, and hold on until the bar is full: %2 s.</source>
        <translation>%1 Tenere fermo, prendere il punto, e continuare a tenere finché la barra è piena: %2 s.</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>%1 ago</source>
        <translation>%1 fa</translation>
    </message>
    <message>
        <source>%1 at %2 s: %3</source>
        <translation>%1 a %2 s: %3</translation>
    </message>
    <message>
        <source>%1 comes back at the next start: the file of the window's settings cannot be written.</source>
        <translation>%1 torna al prossimo avvio: il file delle impostazioni della finestra non può essere scritto.</translation>
    </message>
    <message>
        <source>%1 errors since the start</source>
        <translation>%1 errori dall'avvio</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>%1 h left</source>
        <translation>%1 h rimaste</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>%1 is also open in %2: here it is not saved, and no calibration accepted.</source>
        <translation>%1 è aperto anche in %2: qui non è salvato, e nessuna calibrazione è accettata.</translation>
    </message>
    <message>
        <source>%1 is being written already.</source>
        <translation>%1 è già in scrittura.</translation>
    </message>
    <message>
        <source>%1 is deleted.</source>
        <translation>%1 è eliminata.</translation>
    </message>
    <message>
        <source>%1 is in use by %2: close that one first</source>
        <translation>%1 è in uso da %2: chiudere prima quella</translation>
    </message>
    <message>
        <source>%1 is not saved: the file of the window's settings cannot be written.</source>
        <translation>%1 non è salvata: il file delle impostazioni della finestra non si può scrivere.</translation>
    </message>
    <message>
        <source>%1 is not written: %2</source>
        <translation>%1 non è stato scritto: %2</translation>
    </message>
    <message>
        <source>%1 is saved.</source>
        <translation>%1 è salvata.</translation>
    </message>
    <message>
        <source>%1 is whole: %2 samples.</source>
        <translation>%1 è integro: %2 campioni.</translation>
    </message>
    <message>
        <source>%1 is whole: %2 samples. Nothing was lost; the damaged original is kept as %3.</source>
        <translation>%1 è integro: %2 campioni. Nulla è andato perso; l'originale danneggiato è conservato come %3.</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 è scritto.</translation>
    </message>
    <message>
        <source>%1 kB</source>
        <translation>%1 kB</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 min left</source>
        <translation>%1 min rimasti</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>altri %1</translation>
    </message>
    <message>
        <source>%1 moves by %2; at rest it stays within %3</source>
        <translation>%1 varia di %2; a riposo resta entro %3</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 di %2</translation>
    </message>
    <message>
        <source>%1 of %2 samples, %3 times real time.</source>
        <translation>%1 di %2 campioni, %3 volte il tempo reale.</translation>
    </message>
    <message>
        <source>%1 old</source>
        <translation>vecchio di %1</translation>
    </message>
    <message>
        <source>%1 over time, %2</source>
        <translation>%1 nel tempo, %2</translation>
    </message>
    <message>
        <source>%1 over what is felt; motors %2; too small to turn %3, clipped %4</source>
        <translation>%1 oltre ciò che si sente; motori %2; troppo piccolo per girare %3, tagliato %4</translation>
    </message>
    <message>
        <source>%1 presses of different depth at %2 or more stretches, the least and the greatest among them.</source>
        <translation>%1 pressioni di profondità diversa a %2 o più tensioni, fra cui la minima e la massima.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation>%1 s: %2</translation>
    </message>
    <message>
        <source>%1 s: there are values from %2 s to %3 s.</source>
        <translation>%1 s: ci sono valori da %2 s a %3 s.</translation>
    </message>
    <message>
        <source>%1 samples are not in the file: the computer is too busy. What is written is safe. Close other programs.</source>
        <translation>%1 campioni mancano nel file: il computer è troppo occupato. Ciò che è scritto è al sicuro. Chiudere gli altri programmi.</translation>
    </message>
    <message>
        <source>%1 samples lost</source>
        <translation>%1 campioni persi</translation>
    </message>
    <message>
        <source>%1 steps lie beyond the tolerance stated for that.</source>
        <translation>%1 passi sono oltre la tolleranza indicata per questo.</translation>
    </message>
    <message>
        <source>%1 steps, %2 cycles missed since the start; a step takes %3 µs (median), %4 µs (99th percentile)</source>
        <translation>%1 passi, %2 cicli mancati dall'inizio; un passo dura %3 µs (mediana), %4 µs (99º percentile)</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>da %1 a %2</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <translation>da %1 a %2 %3</translation>
    </message>
    <message>
        <source>%1 to %2: the upper end must be the larger one</source>
        <translation>da %1 a %2: l'estremo superiore deve essere il maggiore</translation>
    </message>
    <message>
        <source>%1 touch %2</source>
        <translation>%1 tocco %2</translation>
    </message>
    <message>
        <source>%1 triangles · %2 pictures/s</source>
        <translation>%1 triangoli · %2 immagini/s</translation>
    </message>
    <message>
        <source>%1 triangles · nothing moves</source>
        <translation>%1 triangoli · tutto fermo</translation>
    </message>
    <message>
        <source>%1 was cancelled; no file is left.</source>
        <translation>%1 è stato annullato; non resta alcun file.</translation>
    </message>
    <message>
        <source>%1 was changed by something else since this console read it. Do it again to overwrite that</source>
        <translation>%1 è stato cambiato da altro da quando questa console lo ha letto. Rifarlo per sovrascrivere</translation>
    </message>
    <message>
        <source>%1 · %2 left out</source>
        <translation>%1 · %2 tralasciati</translation>
    </message>
    <message>
        <source>%1 · %2 min left</source>
        <translation>%1 · ancora %2 min</translation>
    </message>
    <message>
        <source>%1 · coarser while it moves</source>
        <translation>%1 · meno fine mentre si muove</translation>
    </message>
    <message>
        <source>%1 · less than 1 min left</source>
        <translation>%1 · meno di 1 min</translation>
    </message>
    <message>
        <source>%1 · too large: %2</source>
        <translation>%1 · troppo grande: %2</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>%1 × %2 px at %3, %4</source>
        <translation>%1 × %2 px a %3, %4</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, %2 ×, %3. A gesture card is made of a touch in Review.</source>
        <translation>%1, %2 ×, %3. Una scheda di gesto si fa da un tocco in Revisione.</translation>
    </message>
    <message>
        <source>%1, in review</source>
        <translation>%1, in revisione</translation>
    </message>
    <message>
        <source>%1, in the unit beside</source>
        <translation>%1, nell'unità a fianco</translation>
    </message>
    <message>
        <source>%1: "%2" is no number.</source>
        <translation>%1: "%2" non è un numero.</translation>
    </message>
    <message>
        <source>%1: "%2" was not taken. Expected %3.</source>
        <translation>%1: "%2" non accettato. Atteso %3.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2 %</source>
        <translation>%1: %2 %</translation>
    </message>
    <message>
        <source>%1: %2 is out of range; expected %3 to %4 %5.</source>
        <translation>%1: %2 è fuori campo; atteso da %3 a %4 %5.</translation>
    </message>
    <message>
        <source>%1: %2 samples are saved, %3 could not be read. The damaged original is kept as %4.</source>
        <translation>%1: %2 campioni salvati, %3 illeggibili. L'originale danneggiato è conservato come %4.</translation>
    </message>
    <message>
        <source>%1: %2 ± %3</source>
        <translation>%1: %2 ± %3</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>%1: all %2 samples are saved, but not all that belongs to them: %3 could not be read. The damaged original is kept as %4.</source>
        <translation>%1: tutti i %2 campioni sono salvati, ma non tutto ciò che li accompagna: %3 illeggibile. L'originale danneggiato è conservato come %4.</translation>
    </message>
    <message>
        <source>%1: choose the file</source>
        <translation>%1: scegliere il file</translation>
    </message>
    <message>
        <source>%1: difference %2, mean %3</source>
        <translation>%1: differenza %2, media %3</translation>
    </message>
    <message>
        <source>%1: done</source>
        <translation>%1: fatto</translation>
    </message>
    <message>
        <source>%1: expected %2 to %3 s</source>
        <translation>%1: attesi da %2 a %3 s</translation>
    </message>
    <message>
        <source>%1: expected a number from %2 to %3</source>
        <translation>%1: atteso un numero da %2 a %3</translation>
    </message>
    <message>
        <source>%1: now</source>
        <translation>%1: adesso</translation>
    </message>
    <message>
        <source>%1: this folder cannot be made</source>
        <translation>%1: questa cartella non può essere creata</translation>
    </message>
    <message>
        <source>%1: type a number first.</source>
        <translation>%1: scrivere prima un numero.</translation>
    </message>
    <message>
        <source>%1; now %2</source>
        <translation>%1; ora %2</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) lost</source>
        <translation><numerusform>%n campione perso</numerusform><numerusform>%n campioni persi</numerusform></translation>
    </message>
    <message>
        <source>'%1' is no time; expected seconds, such as 83.5, or minutes and seconds, such as 1:23.5.</source>
        <translation>'%1' non è un tempo; attesi secondi, come 83,5, o minuti e secondi, come 1:23,5.</translation>
    </message>
    <message>
        <source>'{}' is no parameter of this program's step</source>
        <translation>'{}' non è un parametro del passo di questo programma</translation>
    </message>
    <message>
        <source>'{}' is not a picture that can be read</source>
        <translation>'{}' non è un'immagine leggibile</translation>
    </message>
    <message>
        <source>'{}' is not a picture that can be read: {}</source>
        <translation>'{}' non è un'immagine leggibile: {}</translation>
    </message>
    <message>
        <source>'{}': expected [[record]]</source>
        <translation>'{}': atteso [[record]]</translation>
    </message>
    <message>
        <source>'{}': expected a date such as 2026-11-21</source>
        <translation>'{}': attesa una data come 2026-11-21</translation>
    </message>
    <message>
        <source>'{}': expected a serial number of 1 to {} characters behind serial=</source>
        <translation>'{}': atteso un numero di serie da 1 a {} caratteri dopo serial=</translation>
    </message>
    <message>
        <source>'{}': expected id=SERIAL, as it stands in {}</source>
        <translation>'{}': atteso id=SERIAL, come sta in {}</translation>
    </message>
    <message>
        <source>'{}': expected id=value</source>
        <translation>'{}': atteso id=value</translation>
    </message>
    <message>
        <source>'{}': expected modbus-tcp:HOST:PORT or modbus-rtu:TTY[:BAUD]</source>
        <translation>'{}': atteso modbus-tcp:HOST:PORT o modbus-rtu:TTY[:BAUD]</translation>
    </message>
    <message>
        <source>, shuffled and deflated</source>
        <translation>, rimescolate e compresse</translation>
    </message>
    <message>
        <source>--after {}: expected a number of seconds from 0 to 3600</source>
        <translation>--after {}: atteso un numero di secondi da 0 a 3600</translation>
    </message>
    <message>
        <source>--catalogue: {}</source>
        <translation>--catalogue: {}</translation>
    </message>
    <message>
        <source>--language {}: expected one of {}</source>
        <translation>--language {}: attesa una di {}</translation>
    </message>
    <message>
        <source>--open {}: expected one or more of {}</source>
        <translation>--open {}: atteso uno o più fra {}</translation>
    </message>
    <message>
        <source>--operator, --subject, --notes and --tag describe a recording; add --record FILE</source>
        <translation>--operator, --subject, --notes e --tag descrivono una registrazione; aggiungere --record FILE</translation>
    </message>
    <message>
        <source>--page {}: expected one of {}</source>
        <translation>--page {}: attesa una di {}</translation>
    </message>
    <message>
        <source>--review {}: no such file, or it may not be read</source>
        <translation>--review {}: il file non esiste, o non può essere letto</translation>
    </message>
    <message>
        <source>--scale {}: expected a number from 0.5 to 4</source>
        <translation>--scale {}: atteso un numero da 0,5 a 4</translation>
    </message>
    <message>
        <source>--simulate contradicts --touchpad {}</source>
        <translation>--simulate contraddice --touchpad {}</translation>
    </message>
    <message>
        <source>--size {}: expected WIDTHxHEIGHT, each from {} to {}</source>
        <translation>--size {}: atteso LARGHEZZAxALTEZZA, ciascuna da {} a {}</translation>
    </message>
    <message>
        <source>--theme {}: expected dark, light or system</source>
        <translation>--theme {}: atteso dark, light o system</translation>
    </message>
    <message>
        <source>--trials: {}</source>
        <translation>--trials: {}</translation>
    </message>
    <message>
        <source>--{} {}: expected a whole number from {} to {}</source>
        <translation>--{} {}: atteso un numero intero da {} a {}</translation>
    </message>
    <message>
        <source>--{}: only with --trials</source>
        <translation>--{}: solo con --trials</translation>
    </message>
    <message>
        <source>/commits: row {} counts backwards</source>
        <translation>/commits: la riga {} conta all'indietro</translation>
    </message>
    <message>
        <source>/commits: row {} is damaged</source>
        <translation>/commits: la riga {} è danneggiata</translation>
    </message>
    <message>
        <source>/commits: {} of {} rows are damaged, the first: row {}</source>
        <translation>/commits: {} righe su {} sono danneggiate, la prima: riga {}</translation>
    </message>
    <message>
        <source>0 s</source>
        <translation>0 s</translation>
    </message>
    <message>
        <source>1 kHz · %1 % missed</source>
        <translation>1 kHz · %1 % mancati</translation>
    </message>
    <message>
        <source>1 kHz · waits for this computer</source>
        <translation>1 kHz · aspetta questo computer</translation>
    </message>
    <message>
        <source>: no. </source>
        <translation>: no. </translation>
    </message>
    <message>
        <source>: yes</source>
        <translation>: sì</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>A %1</source>
        <translation>A %1</translation>
    </message>
    <message>
        <source>A drag in the picture moves the haptic point instead of turning the scene; wheel or Shift: nearer or farther. Without this button: Ctrl and drag.</source>
        <translation>Trascinando nell’immagine si muove il punto aptico invece di girare la scena; rotella o Shift: più vicino o più lontano. Senza questo pulsante: Ctrl e trascinare.</translation>
    </message>
    <message>
        <source>A held button moves the motors: %1.</source>
        <translation>Un pulsante tenuto premuto muove i motori: %1.</translation>
    </message>
    <message>
        <source>A motor goes 2° out and back; the vibration lasts half a second.</source>
        <translation>Un motore va avanti di 2° e torna; la vibrazione dura mezzo secondo.</translation>
    </message>
    <message>
        <source>A note into the recording</source>
        <translation>Una nota nella registrazione</translation>
    </message>
    <message>
        <source>A note needs words.</source>
        <translation>Una nota ha bisogno di parole.</translation>
    </message>
    <message>
        <source>A note; Enter puts it into the recording</source>
        <translation>Una nota; Invio la mette nella registrazione</translation>
    </message>
    <message>
        <source>A recording is beginning or ending. Wait until the disk has answered.</source>
        <translation>Una registrazione sta iniziando o terminando. Attendere che il disco abbia risposto.</translation>
    </message>
    <message>
        <source>A recording is being recovered already; wait, or cancel it.</source>
        <translation>Un recupero è già in corso; attendere o annullarlo.</translation>
    </message>
    <message>
        <source>A recording is under way and would end. End it first.</source>
        <translation>È in corso una registrazione, che finirebbe. Terminarla prima.</translation>
    </message>
    <message>
        <source>A rectangle around the cloth, with a finger in it.</source>
        <translation>Un rettangolo attorno al tessuto, con un dito dentro.</translation>
    </message>
    <message>
        <source>A small file beside the recording, which the simulated finger plays (G)</source>
        <translation>Un piccolo file accanto alla registrazione, che il dito simulato esegue (G)</translation>
    </message>
    <message>
        <source>A test needs motors that answer.</source>
        <translation>Una prova richiede motori che rispondono.</translation>
    </message>
    <message>
        <source>A – B</source>
        <translation>A – B</translation>
    </message>
    <message>
        <source>A: feel the saved values</source>
        <translation>A: sentire i valori salvati</translation>
    </message>
    <message>
        <source>A: feel the saved values. Nothing can be changed meanwhile (Ctrl+B)</source>
        <translation>A: sentire i valori salvati. Intanto nulla può essere cambiato (Ctrl+B)</translation>
    </message>
    <message>
        <source>A: saved</source>
        <translation>A: salvato</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Accelerazione</translation>
    </message>
    <message>
        <source>Acceleration %1</source>
        <translation>Accelerazione %1</translation>
    </message>
    <message>
        <source>Acceleration of the finger over that of the rollers, far below the resonance.</source>
        <translation>Accelerazione del dito rispetto a quella dei rulli, molto al di sotto della risonanza.</translation>
    </message>
    <message>
        <source>Acceleration, x</source>
        <translation>Accelerazione, x</translation>
    </message>
    <message>
        <source>Acceleration, y</source>
        <translation>Accelerazione, y</translation>
    </message>
    <message>
        <source>Acceleration, z</source>
        <translation>Accelerazione, z</translation>
    </message>
    <message>
        <source>Accelerations further apart than this are a gap, during which the texture is silent.</source>
        <translation>Accelerazioni più distanti di così sono una lacuna, durante la quale la texture tace.</translation>
    </message>
    <message>
        <source>Accelerometer at rest</source>
        <translation>Accelerometro a riposo</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Accetta</translation>
    </message>
    <message>
        <source>Accept the calibration</source>
        <translation>Accetta la calibrazione</translation>
    </message>
    <message>
        <source>Accept the proposed values</source>
        <translation>Accetta i valori proposti</translation>
    </message>
    <message>
        <source>Accepted and noted beside %1. It changes no value.</source>
        <translation>Accettata e annotata accanto a %1. Non cambia alcun valore.</translation>
    </message>
    <message>
        <source>Accepted and written to %1, but the session goes on without it: %2. Start the window again to use it.</source>
        <translation>Accettato e scritto in %1, ma la sessione continua senza: %2. Riavviare la finestra per usarlo.</translation>
    </message>
    <message>
        <source>Accepted and written to %1, but the session is closed: %2. Choose devices under Devices.</source>
        <translation>Accettato e scritto in %1, ma la sessione è chiusa: %2. Scegliere i dispositivi in Dispositivi.</translation>
    </message>
    <message>
        <source>Accepted and written to %1. The session has begun anew with it; motors stay off until you arm.</source>
        <translation>Accettato e scritto in %1. La sessione è ricominciata con esso; i motori restano spenti finché non si arma.</translation>
    </message>
    <message>
        <source>Accepted. The values are in force and in the profile.</source>
        <translation>Accettato. I valori sono in vigore e nel profilo.</translation>
    </message>
    <message>
        <source>Accepted. The values are in the profile, not in force.</source>
        <translation>Accettata. I valori sono nel profilo, non in vigore.</translation>
    </message>
    <message>
        <source>Accepted: the proposed values are in use. Undo takes them back, Save profile keeps them.</source>
        <translation>Accettato: i valori proposti sono in uso. Annulla li toglie, Salva il profilo li conserva.</translation>
    </message>
    <message>
        <source>Accepting begins the session anew and would end the recording: stop the recording first.</source>
        <translation>Accettare fa ricominciare la sessione e terminerebbe la registrazione: fermare prima la registrazione.</translation>
    </message>
    <message>
        <source>Accepting begins the session anew, and that is not done while motors can move: press Esc first.</source>
        <translation>Accettare fa ricominciare la sessione, e non si fa mentre i motori possono muoversi: premere prima Esc.</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Attivo</translation>
    </message>
    <message>
        <source>Adaptive mode: a finger is darker than the lit cloth by at least this part of it.</source>
        <translation>Modo adaptive: un dito è più scuro del tessuto illuminato almeno di questa frazione.</translation>
    </message>
    <message>
        <source>Adaptive mode: smallest dark area that counts as a touch, on the cloth.</source>
        <translation>Modo adaptive: minima area scura che conta come tocco, sul tessuto.</translation>
    </message>
    <message>
        <source>Adaptive mode: use every n-th pixel and row, for slow computers.</source>
        <translation>Modo adaptive: usa un pixel e una riga ogni n, per i computer lenti.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Aggiungi</translation>
    </message>
    <message>
        <source>Address already in use</source>
        <translation>l'indirizzo è già in uso</translation>
    </message>
    <message>
        <source>Address and port to listen on</source>
        <translation>Indirizzo e porta di ascolto</translation>
    </message>
    <message>
        <source>Advance from a frame to the next: whole frames are blocks, less overlaps them.</source>
        <translation>Avanzamento da un frame al seguente: un frame intero dà blocchi, meno li sovrappone.</translation>
    </message>
    <message>
        <source>Again and again</source>
        <translation>Di continuo</translation>
    </message>
    <message>
        <source>Age of inputs</source>
        <translation>Età degli ingressi</translation>
    </message>
    <message>
        <source>Align the other session at</source>
        <translation>Allinea l'altra sessione a</translation>
    </message>
    <message>
        <source>Align this session at</source>
        <translation>Allinea questa sessione a</translation>
    </message>
    <message>
        <source>All %1 trials are done.</source>
        <translation>Tutte le %1 prove sono fatte.</translation>
    </message>
    <message>
        <source>All back to saved</source>
        <translation>Tutto al salvato</translation>
    </message>
    <message>
        <source>All live parameters</source>
        <translation>Tutti i parametri dal vivo</translation>
    </message>
    <message>
        <source>All values back to saved</source>
        <translation>Riporta tutti i valori a quelli salvati</translation>
    </message>
    <message>
        <source>Amplitude over frequency, Hz</source>
        <translation>Ampiezza in frequenza, Hz</translation>
    </message>
    <message>
        <source>Amplitude, %1</source>
        <translation>Ampiezza, %1</translation>
    </message>
    <message>
        <source>An indentation less certain than this is unavailable.</source>
        <translation>Un'indentazione meno certa di così non è disponibile.</translation>
    </message>
    <message>
        <source>Another program drives the touchpad</source>
        <translation>Un altro programma comanda il touchpad</translation>
    </message>
    <message>
        <source>Another program has the motor board</source>
        <translation>Un altro programma usa la scheda dei motori</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Risposte</translation>
    </message>
    <message>
        <source>Any recording's file (Ctrl+O); it can be dropped onto the window, too</source>
        <translation>Il file di una registrazione qualsiasi (Ctrl+O); si può anche lasciar cadere sulla finestra</translation>
    </message>
    <message>
        <source>Apply anyway</source>
        <translation>Applica lo stesso</translation>
    </message>
    <message>
        <source>Area, mm²</source>
        <translation>Area, mm²</translation>
    </message>
    <message>
        <source>Arm: go to the button that is held</source>
        <translation>Armare: al pulsante da tenere premuto</translation>
    </message>
    <message>
        <source>Arrived</source>
        <translation>Arrivato</translation>
    </message>
    <message>
        <source>As spring, but softer where the cloth would give back more than the finger put in.</source>
        <translation>Come spring, ma più cedevole dove il tessuto restituirebbe più di quanto il dito ha messo.</translation>
    </message>
    <message>
        <source>Asked</source>
        <translation>Chiesto</translation>
    </message>
    <message>
        <source>Asking the devices whether they answer …</source>
        <translation>Si chiede ai dispositivi se rispondono …</translation>
    </message>
    <message>
        <source>Asking the devices whether they answer. The present session goes on meanwhile.</source>
        <translation>Si chiede ai dispositivi se rispondono. La sessione attuale intanto continua.</translation>
    </message>
    <message>
        <source>At A</source>
        <translation>In A</translation>
    </message>
    <message>
        <source>At B</source>
        <translation>In B</translation>
    </message>
    <message>
        <source>At least %1 different distances that span %2 mm.</source>
        <translation>Almeno %1 distanze diverse che coprano %2 mm.</translation>
    </message>
    <message>
        <source>At least %1 different weights that span %2 N.</source>
        <translation>Almeno %1 pesi diversi che coprano %2 N.</translation>
    </message>
    <message>
        <source>At least %1 places, not on one line.</source>
        <translation>Almeno %1 posizioni, non su una retta.</translation>
    </message>
    <message>
        <source>Auto-tune</source>
        <translation>Regolazione automatica</translation>
    </message>
    <message>
        <source>Averages the signal and adds it to the points.</source>
        <translation>Fa la media del segnale e la aggiunge ai punti.</translation>
    </message>
    <message>
        <source>Averaging</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Averaging for %1 s: keep still.</source>
        <translation>Media per %1 s: restare fermi.</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>B %1</source>
        <translation>B %1</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>B: current</source>
        <translation>B: attuale</translation>
    </message>
    <message>
        <source>B: feel the current values</source>
        <translation>B: sentire i valori attuali</translation>
    </message>
    <message>
        <source>B: feel the current values (Ctrl+B)</source>
        <translation>B: sentire i valori attuali (Ctrl+B)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Indietro</translation>
    </message>
    <message>
        <source>Back to saved</source>
        <translation>Torna al salvato</translation>
    </message>
    <message>
        <source>Back to the default, %1</source>
        <translation>Torna al valore predefinito, %1</translation>
    </message>
    <message>
        <source>Back to the saved value of %1</source>
        <translation>Torna al valore salvato di %1</translation>
    </message>
    <message>
        <source>Back to the saved value, %1</source>
        <translation>Torna al valore salvato, %1</translation>
    </message>
    <message>
        <source>Bad file descriptor</source>
        <translation>descrittore di file non valido</translation>
    </message>
    <message>
        <source>Began, UTC</source>
        <translation>Inizio, UTC</translation>
    </message>
    <message>
        <source>Beside, mm</source>
        <translation>A lato, mm</translation>
    </message>
    <message>
        <source>Between A and B</source>
        <translation>Tra A e B</translation>
    </message>
    <message>
        <source>Bookmark at the cursor</source>
        <translation>Segnalibro al cursore</translation>
    </message>
    <message>
        <source>Both ends: this range is kept. Both empty: it follows the values.</source>
        <translation>Entrambi gli estremi: questo intervallo resta. Entrambi vuoti: segue i valori.</translation>
    </message>
    <message>
        <source>Bridge</source>
        <translation>Ponte</translation>
    </message>
    <message>
        <source>Bridge, mV/V</source>
        <translation>Ponte, mV/V</translation>
    </message>
    <message>
        <source>Brightness, contrast, exposure</source>
        <translation>Luminosità, contrasto, esposizione</translation>
    </message>
    <message>
        <source>Broken pipe</source>
        <translation>la connessione è interrotta</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>A mano</translation>
    </message>
    <message>
        <source>CSV table</source>
        <translation>Tabella CSV</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Calibra</translation>
    </message>
    <message>
        <source>Calibrate (the simulation needs none)</source>
        <translation>Calibra (la simulazione non ne ha bisogno)</translation>
    </message>
    <message>
        <source>Calibrate it again under Calibrate. It does not keep you from arming.</source>
        <translation>Rifare la calibrazione in Calibra. Non impedisce di armare.</translation>
    </message>
    <message>
        <source>Calibrate this one under Calibrate. It does not keep you from arming.</source>
        <translation>Calibrarlo in Calibra. Non impedisce di armare.</translation>
    </message>
    <message>
        <source>Calibrate: %1 of %2 parts</source>
        <translation>Calibra: %1 parti su %2</translation>
    </message>
    <message>
        <source>Calibrated on this touchpad</source>
        <translation>Calibrato su questo touchpad</translation>
    </message>
    <message>
        <source>Calibration points read with the former values are discarded: take them again (%1).</source>
        <translation>I punti di calibrazione letti con i valori precedenti sono scartati: riprenderli (%1).</translation>
    </message>
    <message>
        <source>Calibration report as PDF</source>
        <translation>Rapporto di calibrazione in PDF</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Telecamera</translation>
    </message>
    <message>
        <source>Camera height</source>
        <translation>Altezza della telecamera</translation>
    </message>
    <message>
        <source>Camera of this computer</source>
        <translation>Telecamera di questo computer</translation>
    </message>
    <message>
        <source>Camera panel</source>
        <translation>Pannello della telecamera</translation>
    </message>
    <message>
        <source>Camera picture</source>
        <translation>Immagine della telecamera</translation>
    </message>
    <message>
        <source>Camera picture: click a place, or move it with the arrow keys</source>
        <translation>Immagine della telecamera: fare clic su un punto, o spostarlo con le frecce</translation>
    </message>
    <message>
        <source>Camera sees</source>
        <translation>La telecamera vede</translation>
    </message>
    <message>
        <source>Camera: region, threshold</source>
        <translation>Telecamera: regione, soglia</translation>
    </message>
    <message>
        <source>Camera: scale</source>
        <translation>Telecamera: scala</translation>
    </message>
    <message>
        <source>Can I trust the sensors?</source>
        <translation>Posso fidarmi dei sensori?</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Cancel auto-tune</source>
        <translation>Annulla la regolazione automatica</translation>
    </message>
    <message>
        <source>Cancel the newest with %1</source>
        <translation>Annulla il più recente con %1</translation>
    </message>
    <message>
        <source>Cancel what is running</source>
        <translation>Annulla ciò che è in corso</translation>
    </message>
    <message>
        <source>Cancel: %1</source>
        <translation>Annulla: %1</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Annullato.</translation>
    </message>
    <message>
        <source>Cancelled; nothing was changed.</source>
        <translation>Annullato; nulla è stato cambiato.</translation>
    </message>
    <message>
        <source>Cancelling: %1</source>
        <translation>Annullamento: %1</translation>
    </message>
    <message>
        <source>Cannot allocate memory</source>
        <translation>memoria insufficiente</translation>
    </message>
    <message>
        <source>Cannot assign requested address</source>
        <translation>l'indirizzo richiesto non può essere assegnato</translation>
    </message>
    <message>
        <source>Cartesian impedance</source>
        <translation>impedenza cartesiana</translation>
    </message>
    <message>
        <source>Change the robot</source>
        <translation>Cambia il robot</translation>
    </message>
    <message>
        <source>Change, mm</source>
        <translation>Variazione, mm</translation>
    </message>
    <message>
        <source>Changed parameters; Enter takes one away</source>
        <translation>Parametri cambiati; Invio ne toglie uno</translation>
    </message>
    <message>
        <source>Changed, not saved</source>
        <translation>Cambiato, non salvato</translation>
    </message>
    <message>
        <source>Changed; the profile has %1</source>
        <translation>Cambiato; il profilo ha %1</translation>
    </message>
    <message>
        <source>Check light and lens cap.</source>
        <translation>Controllare la luce e il coperchio dell'obiettivo.</translation>
    </message>
    <message>
        <source>Check the cable of the camera %1, or choose another source.</source>
        <translation>Controllare il cavo della telecamera %1, o scegliere un'altra sorgente.</translation>
    </message>
    <message>
        <source>Check the camera's cable or choose another source.</source>
        <translation>Controllare il cavo della telecamera o scegliere un'altra sorgente.</translation>
    </message>
    <message>
        <source>Check the load cell's bridge and its cable.</source>
        <translation>Controllare il ponte della cella di carico e il suo cavo.</translation>
    </message>
    <message>
        <source>Check the motor board's power and its serial cable at %1.</source>
        <translation>Controllare l'alimentazione della scheda motori e il suo cavo seriale a %1.</translation>
    </message>
    <message>
        <source>Check the network and the robot's program.</source>
        <translation>Controllare la rete e il programma del robot.</translation>
    </message>
    <message>
        <source>Check the network cable and the robot's program; it is awaited at %1.</source>
        <translation>Controllare il cavo di rete e il programma del robot; lo si attende a %1.</translation>
    </message>
    <message>
        <source>Check the network cable and what sends the pictures at %1.</source>
        <translation>Controllare il cavo di rete e ciò che invia le immagini a %1.</translation>
    </message>
    <message>
        <source>Check the robot's force sensor and probe again.</source>
        <translation>Controllare il sensore di forza del robot e tastare di nuovo.</translation>
    </message>
    <message>
        <source>Check the touchpad's power and cables.</source>
        <translation>Controllare l'alimentazione e i cavi del touchpad.</translation>
    </message>
    <message>
        <source>Check the touchpad's power and its cable.</source>
        <translation>Controllare l'alimentazione del touchpad e il suo cavo.</translation>
    </message>
    <message>
        <source>Check the touchpad's power and its network cable to %1.</source>
        <translation>Controllare l'alimentazione del touchpad e il suo cavo di rete verso %1.</translation>
    </message>
    <message>
        <source>Check the touchpad's power and its serial cable at %1.</source>
        <translation>Controllare l'alimentazione del touchpad e il suo cavo seriale a %1.</translation>
    </message>
    <message>
        <source>Choice of curves</source>
        <translation>Scelta delle curve</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Scegli un file…</translation>
    </message>
    <message>
        <source>Choose a second recording: its curves are drawn faint behind these. In the list of sessions, two can be chosen at once.</source>
        <translation>Scegliere una seconda registrazione: le sue curve sono disegnate tenui dietro queste. Nell'elenco delle sessioni se ne possono scegliere due insieme.</translation>
    </message>
    <message>
        <source>Choose a session, or write the path of a recording.</source>
        <translation>Scegliere una sessione, o scrivere il percorso di una registrazione.</translation>
    </message>
    <message>
        <source>Choose a touch in the list first.</source>
        <translation>Scegliere prima un tocco nell'elenco.</translation>
    </message>
    <message>
        <source>Choose curves</source>
        <translation>Scegli le curve</translation>
    </message>
    <message>
        <source>Choose others</source>
        <translation>Sceglierne altri</translation>
    </message>
    <message>
        <source>Choose the camera.</source>
        <translation>Scegliere la telecamera.</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Scegli il file</translation>
    </message>
    <message>
        <source>Choose the folder.</source>
        <translation>Scegliere la cartella.</translation>
    </message>
    <message>
        <source>Choose the key file</source>
        <translation>Scegli il file della chiave</translation>
    </message>
    <message>
        <source>Choose the key file that the robot has as well.</source>
        <translation>Scegliere il file della chiave che ha anche il robot.</translation>
    </message>
    <message>
        <source>Choose the motor board's serial port.</source>
        <translation>Scegliere la porta seriale della scheda motori.</translation>
    </message>
    <message>
        <source>Choose the recording.</source>
        <translation>Scegliere la registrazione.</translation>
    </message>
    <message>
        <source>Choose the robot's stiffness or set one by hand.</source>
        <translation>Scegliere la rigidezza del robot o impostarne una a mano.</translation>
    </message>
    <message>
        <source>Choose the scene file</source>
        <translation>Scegli il file della scena</translation>
    </message>
    <message>
        <source>Choose the scene file.</source>
        <translation>Scegliere il file della scena.</translation>
    </message>
    <message>
        <source>Choose the serial port; behind a colon its speed, 115 200 Bd without.</source>
        <translation>Scegliere la porta seriale; dopo due punti la sua velocità, senza è 115 200 Bd.</translation>
    </message>
    <message>
        <source>Choose the touchpad and its camera in Devices, then press Connect there.</source>
        <translation>Scegliere il touchpad e la sua telecamera in Dispositivi, poi premere lì Collega.</translation>
    </message>
    <message>
        <source>Choose the video file.</source>
        <translation>Scegliere il file video.</translation>
    </message>
    <message>
        <source>Choose them under Devices.</source>
        <translation>Sceglierli in Dispositivi.</translation>
    </message>
    <message>
        <source>Choose two sessions to compare, the second with Ctrl.</source>
        <translation>Scegliere due sessioni da confrontare, la seconda con Ctrl.</translation>
    </message>
    <message>
        <source>Choose two sessions, the second with Ctrl: the later one is drawn faint behind the first.</source>
        <translation>Scegliere due sessioni, la seconda con Ctrl: la più recente è disegnata tenue dietro la prima.</translation>
    </message>
    <message>
        <source>Classic (not secured)</source>
        <translation>Classico (non protetto)</translation>
    </message>
    <message>
        <source>Click for more.</source>
        <translation>Fare clic per saperne di più.</translation>
    </message>
    <message>
        <source>Click the next mark, type where it lies, and take the point: best at the cloth's corners and in its middle. Marks that you press down, with their depth, tell how high the camera is.</source>
        <translation>Fare clic sul segno successivo, scrivere dove si trova, e prendere il punto: meglio agli angoli del tessuto e al centro. Segni premuti in basso, con la loro profondità, dicono a che altezza è la telecamera.</translation>
    </message>
    <message>
        <source>Click to look there; drag with the right button to choose a stretch.</source>
        <translation>Fare clic per guardare lì; trascinare col tasto destro per scegliere un tratto.</translation>
    </message>
    <message>
        <source>Close other programs on this machine.</source>
        <translation>Chiudere gli altri programmi su questo computer.</translation>
    </message>
    <message>
        <source>Close the camera's panel</source>
        <translation>Chiudi il pannello della telecamera</translation>
    </message>
    <message>
        <source>Close the choice of curves</source>
        <translation>Chiudi la scelta delle curve</translation>
    </message>
    <message>
        <source>Close the link's panel</source>
        <translation>Chiudi il pannello del collegamento</translation>
    </message>
    <message>
        <source>Close the log</source>
        <translation>Chiudi il registro</translation>
    </message>
    <message>
        <source>Close the manual</source>
        <translation>Chiudi il manuale</translation>
    </message>
    <message>
        <source>Close the readiness list</source>
        <translation>Chiudi l'elenco di prontezza</translation>
    </message>
    <message>
        <source>Close the recording's panel</source>
        <translation>Chiudi il pannello della registrazione</translation>
    </message>
    <message>
        <source>Close the scene's panel</source>
        <translation>Chiudi il pannello della scena</translation>
    </message>
    <message>
        <source>Close the tuning panel</source>
        <translation>Chiudi il pannello di regolazione</translation>
    </message>
    <message>
        <source>Close what has it at %1, such as another console; this one then takes it by itself.</source>
        <translation>Chiudere ciò che lo usa su %1, per esempio un'altra console; questa lo prende poi da sola.</translation>
    </message>
    <message>
        <source>Close: %1</source>
        <translation>Chiudi: %1</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Chiuso</translation>
    </message>
    <message>
        <source>Closed loop: motors and cloth answer as identified from this recording.</source>
        <translation>Anello chiuso: motori e tessuto rispondono come identificati da questa registrazione.</translation>
    </message>
    <message>
        <source>Closed: the robot has said goodbye</source>
        <translation>Chiuso: il robot si è congedato</translation>
    </message>
    <message>
        <source>Cloth</source>
        <translation>Tessuto</translation>
    </message>
    <message>
        <source>Cloth %1 times its law's stiffness; sensors %2 s late with a lag of %3 s, noise %4 %. The courses above show what the proposal would do. Nothing is changed yet.</source>
        <translation>Tessuto %1 volte la rigidezza della sua legge; sensori in ritardo di %2 s con costante di tempo di %3 s, rumore %4 %. Gli andamenti sopra mostrano che cosa farebbe la proposta. Nulla è ancora cambiato.</translation>
    </message>
    <message>
        <source>Cloth edges</source>
        <translation>Bordi del tessuto</translation>
    </message>
    <message>
        <source>Cloth tension ratio</source>
        <translation>Rapporto di tensione del tessuto</translation>
    </message>
    <message>
        <source>Coefficient</source>
        <translation>Coefficiente</translation>
    </message>
    <message>
        <source>Commanded, °</source>
        <translation>Comandato, °</translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation>Comandi trovati</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Confronta</translation>
    </message>
    <message>
        <source>Compare the two</source>
        <translation>Confronta le due</translation>
    </message>
    <message>
        <source>Compare the two chosen sessions</source>
        <translation>Confronta le due sessioni scelte</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Condizioni</translation>
    </message>
    <message>
        <source>Conditions: light, temperature, target</source>
        <translation>Condizioni: luce, temperatura, bersaglio</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Collega</translation>
    </message>
    <message>
        <source>Connect devices</source>
        <translation>Collega i dispositivi</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Connesso</translation>
    </message>
    <message>
        <source>Connected: %1.</source>
        <translation>Collegato: %1.</translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation>connessione rifiutata</translation>
    </message>
    <message>
        <source>Connection reset by peer</source>
        <translation>connessione chiusa dall'altra parte</translation>
    </message>
    <message>
        <source>Connection timed out</source>
        <translation>tempo di connessione scaduto</translation>
    </message>
    <message>
        <source>Contact mode: from the camera's lens to the untouched cloth.</source>
        <translation>Modo contact: dall'obiettivo della telecamera al tessuto non toccato.</translation>
    </message>
    <message>
        <source>Contact mode: held on all four sides, or held by two rollers left and right with front and back free.</source>
        <translation>Modo contact: tenuto sui quattro lati, o tenuto da due rulli a sinistra e a destra con davanti e dietro liberi.</translation>
    </message>
    <message>
        <source>Contact mode: how uncertain that ratio is, as a part of it.</source>
        <translation>Modo contact: quanto è incerto questo rapporto, come parte di esso.</translation>
    </message>
    <message>
        <source>Contact mode: how uncertain that share is.</source>
        <translation>Modo contact: quanto è incerta questa parte.</translation>
    </message>
    <message>
        <source>Contact mode: radius of the disc that the finger looks like from afar, as a share of the contact's: 0.6 for a sphere, 1 for a flat disc.</source>
        <translation>Modo contact: raggio del disco che il dito sembra da lontano, come parte di quello del contatto: 0,6 per una sfera, 1 per un disco piatto.</translation>
    </message>
    <message>
        <source>Contact mode: the cloth's tension from left to right over that from front to back.</source>
        <translation>Modo contact: tensione del tessuto da sinistra a destra divisa per quella da davanti a dietro.</translation>
    </message>
    <message>
        <source>Contact mode: what the cloth's formula leaves of each sensor's share, as a part of the indentation.</source>
        <translation>Modo contact: ciò che la formula del tessuto lascia nella quota di ogni sensore, come parte dell'indentazione.</translation>
    </message>
    <message>
        <source>Contact radius share</source>
        <translation>Quota del raggio di contatto</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Indice</translation>
    </message>
    <message>
        <source>Controls</source>
        <translation>Comandi</translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation>Copia il percorso</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Taglio</translation>
    </message>
    <message>
        <source>Corner (-3 dB) of the default high-pass.</source>
        <translation>Frequenza di taglio (-3 dB) del passa-alto predefinito.</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Correzione</translation>
    </message>
    <message>
        <source>Correction limit</source>
        <translation>Limite di correzione</translation>
    </message>
    <message>
        <source>Coupling</source>
        <translation>Accoppiamento</translation>
    </message>
    <message>
        <source>Crossfade</source>
        <translation>Passaggio</translation>
    </message>
    <message>
        <source>Cursor</source>
        <translation>Cursore</translation>
    </message>
    <message>
        <source>Cursor back by a hundredth</source>
        <translation>Cursore indietro di un centesimo</translation>
    </message>
    <message>
        <source>Cursor on by a hundredth</source>
        <translation>Cursore avanti di un centesimo</translation>
    </message>
    <message>
        <source>Cursor to the next sample</source>
        <translation>Cursore al campione successivo</translation>
    </message>
    <message>
        <source>Cursor to the previous sample</source>
        <translation>Cursore al campione precedente</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Curve</translation>
    </message>
    <message>
        <source>Cycles missed</source>
        <translation>Cicli mancati</translation>
    </message>
    <message>
        <source>Damping ratio of that resonance.</source>
        <translation>Rapporto di smorzamento di quella risonanza.</translation>
    </message>
    <message>
        <source>Dark theme</source>
        <translation>Tema scuro</translation>
    </message>
    <message>
        <source>Dead band</source>
        <translation>Banda morta</translation>
    </message>
    <message>
        <source>Dead time of the measured stiffness behind the stretch; auto-tune measures it.</source>
        <translation>Tempo morto della rigidezza misurata rispetto alla tensione; la regolazione automatica lo misura.</translation>
    </message>
    <message>
        <source>Dead zone</source>
        <translation>Zona morta</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Elimina</translation>
    </message>
    <message>
        <source>Delete the chosen preset</source>
        <translation>Elimina la preimpostazione scelta</translation>
    </message>
    <message>
        <source>Delete the chosen preset; undo brings it back</source>
        <translation>Elimina la preimpostazione scelta; Annulla la riporta</translation>
    </message>
    <message>
        <source>Demonstration</source>
        <translation>Dimostrazione</translation>
    </message>
    <message>
        <source>Demonstration by the simulated finger</source>
        <translation>Dimostrazione del dito simulato</translation>
    </message>
    <message>
        <source>Depth
mm</source>
        <translation>Profondità
mm</translation>
    </message>
    <message>
        <source>Depth at the sensor under the finger, mm</source>
        <translation>Profondità al sensore sotto il dito, mm</translation>
    </message>
    <message>
        <source>Depth there, mm</source>
        <translation>Profondità lì, mm</translation>
    </message>
    <message>
        <source>Depth, mm</source>
        <translation>Profondità, mm</translation>
    </message>
    <message>
        <source>Derivative filter</source>
        <translation>Filtro derivativo</translation>
    </message>
    <message>
        <source>Derivative gain in thesis mode (the thesis used none).</source>
        <translation>Guadagno derivativo nel modo thesis (la tesi non ne usava).</translation>
    </message>
    <message>
        <source>Derivative gain, on the measured stiffness and not on the target.</source>
        <translation>Guadagno derivativo, sulla rigidezza misurata e non sull'obiettivo.</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>dispositivo o risorsa occupati</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Dispositivi</translation>
    </message>
    <message>
        <source>Devices can be changed only while nothing can move. Press Esc first.</source>
        <translation>I dispositivi si possono cambiare solo mentre nulla si può muovere. Premere prima Esc.</translation>
    </message>
    <message>
        <source>Devices not found</source>
        <translation>Dispositivi non trovati</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Differenze</translation>
    </message>
    <message>
        <source>Differences, presets, auto-tune, read back</source>
        <translation>Differenze, preimpostazioni, regolazione automatica, riletto</translation>
    </message>
    <message>
        <source>Different from %1 s on (%2).</source>
        <translation>Diverso da %1 s in poi (%2).</translation>
    </message>
    <message>
        <source>Directory not empty</source>
        <translation>la cartella non è vuota</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Scarta</translation>
    </message>
    <message>
        <source>Discard the points</source>
        <translation>Scarta i punti</translation>
    </message>
    <message>
        <source>Discard the proposed values</source>
        <translation>Scarta i valori proposti</translation>
    </message>
    <message>
        <source>Discarded; nothing was changed.</source>
        <translation>Scartato; nulla è stato cambiato.</translation>
    </message>
    <message>
        <source>Disconnected</source>
        <translation>Disconnesso</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>quota del disco superata</translation>
    </message>
    <message>
        <source>Dismiss all notices</source>
        <translation>Chiudi tutti gli avvisi</translation>
    </message>
    <message>
        <source>Dismiss: %1</source>
        <translation>Chiudi: %1</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distanza</translation>
    </message>
    <message>
        <source>Distance %1</source>
        <translation>Distanza %1</translation>
    </message>
    <message>
        <source>Distance sensor</source>
        <translation>Sensore di distanza</translation>
    </message>
    <message>
        <source>Distance sensor {}</source>
        <translation>Sensore di distanza {}</translation>
    </message>
    <message>
        <source>Distance sensor's curve of volts, as its form says; empty: the thesis polynomial.</source>
        <translation>Curva del sensore di distanza in funzione dei volt, come dice la sua forma; vuota: il polinomio della tesi.</translation>
    </message>
    <message>
        <source>Distance sensors measure</source>
        <translation>I sensori di distanza misurano</translation>
    </message>
    <message>
        <source>Distance sensors: distance to the untouched cloth; the tare sets it.</source>
        <translation>Sensori di distanza: distanza dal tessuto non toccato; la imposta la tara.</translation>
    </message>
    <message>
        <source>Distance sensors: highest valid ADC code of each.</source>
        <translation>Sensori di distanza: codice ADC valido più alto di ciascuno.</translation>
    </message>
    <message>
        <source>Distance sensors: lowest valid ADC code of each.</source>
        <translation>Sensori di distanza: codice ADC valido più basso di ciascuno.</translation>
    </message>
    <message>
        <source>Distance sensors: noise of one reading.</source>
        <translation>Sensori di distanza: rumore di una lettura.</translation>
    </message>
    <message>
        <source>Distance sensors: x of each; as many as there are.</source>
        <translation>Sensori di distanza: x di ciascuno; tanti quanti sono.</translation>
    </message>
    <message>
        <source>Distance sensors: y of each.</source>
        <translation>Sensori di distanza: y di ciascuno.</translation>
    </message>
    <message>
        <source>Distance, mm</source>
        <translation>Distanza, mm</translation>
    </message>
    <message>
        <source>Distances, mm</source>
        <translation>Distanze, mm</translation>
    </message>
    <message>
        <source>Dots: both encoders with the new zero and sign. Line: where the motors were sent. Dashed: the first encoder as it is read now.</source>
        <translation>Punti: entrambi gli encoder con nuovo zero e segno. Linea: dove i motori sono stati mandati. Tratteggio: il primo encoder come è letto ora.</translation>
    </message>
    <message>
        <source>Dots: each press, what the sensors beside the finger read of it. Below, how far the fit is off there.</source>
        <translation>Punti: ogni pressione, ciò che ne leggono i sensori a lato del dito. Sotto, di quanto l'adattamento vi sbaglia.</translation>
    </message>
    <message>
        <source>Dots: each press. Bars: an angle's stiffness with its 95 % interval. Line: the new law. Dashed: the one in force. Crosses: presses the others contradict.</source>
        <translation>Punti: ogni pressione. Barre: rigidezza di un angolo con l'intervallo del 95 %. Linea: la nuova legge. Tratteggio: quella in vigore. Croci: pressioni che le altre contraddicono.</translation>
    </message>
    <message>
        <source>Dots: length of each reading. Line: their mean. Dashed: what is expected.</source>
        <translation>Punti: modulo di ogni lettura. Linea: la media. Tratteggio: quanto atteso.</translation>
    </message>
    <message>
        <source>Dots: measured. Dashed: the offsets in force.</source>
        <translation>Punti: misurati. Tratteggio: gli offset in vigore.</translation>
    </message>
    <message>
        <source>Dots: the resonance at each stretch, with its uncertainty. Line: what the texture will reckon with. Dashed: what it reckons with now.</source>
        <translation>Punti: la risonanza a ogni tensione, con la sua incertezza. Linea: ciò di cui la texture terrà conto. Tratteggiata: ciò di cui tiene conto ora.</translation>
    </message>
    <message>
        <source>Drag to look back, wheel to zoom, drag with the right button to zoom into a box,
Ctrl and wheel to stretch this curve, double-click or F to follow again.</source>
        <translation>Trascinare per guardare indietro, rotella per ingrandire, trascinare col tasto destro per ingrandire un riquadro,
Ctrl e rotella per allungare questa curva, doppio clic o F per seguire di nuovo.</translation>
    </message>
    <message>
        <source>Drag to look elsewhere, wheel to zoom, drag with the right button to zoom into a box,
Ctrl and wheel to stretch this curve, double-click for the whole session.</source>
        <translation>Trascinare per guardare altrove, rotella per ingrandire, trascinare col tasto destro per ingrandire un riquadro,
Ctrl e rotella per allungare questa curva, doppio clic per tutta la sessione.</translation>
    </message>
    <message>
        <source>Drag: touch · Shift or wheel: depth · right button: move</source>
        <translation>Trascina: tocca · Shift o rotella: profondità · tasto destro: sposta</translation>
    </message>
    <message>
        <source>Drag: turn · Shift: move · wheel: zoom</source>
        <translation>Trascina: gira · Shift: sposta · rotella: zoom</translation>
    </message>
    <message>
        <source>Drag: turn · Shift: move · wheel: zoom · Ctrl: touch</source>
        <translation>Trascina: gira · Shift: sposta · rotella: zoom · Ctrl: tocca</translation>
    </message>
    <message>
        <source>Drawn faint. Choose a touch of each to lay one on the other.</source>
        <translation>Disegnata tenue. Scegliere un tocco di ciascuna per sovrapporli.</translation>
    </message>
    <message>
        <source>Drawn faint. The search for its touches was cancelled.</source>
        <translation>Disegnata tenue. La ricerca dei suoi tocchi è stata annullata.</translation>
    </message>
    <message>
        <source>Duty that the first motor needs before it turns.</source>
        <translation>Duty di cui il primo motore ha bisogno per girare.</translation>
    </message>
    <message>
        <source>Duty that the second motor needs before it turns.</source>
        <translation>Duty di cui il secondo motore ha bisogno per girare.</translation>
    </message>
    <message>
        <source>Duty with which the board's own position loop answers a degree.</source>
        <translation>Duty con cui l'anello di posizione della scheda risponde a un grado.</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Modifica</translation>
    </message>
    <message>
        <source>Encoder 1</source>
        <translation>Encoder 1</translation>
    </message>
    <message>
        <source>Encoder 2</source>
        <translation>Encoder 2</translation>
    </message>
    <message>
        <source>Encoders: sign, zero, range</source>
        <translation>Encoder: segno, zero, campo</translation>
    </message>
    <message>
        <source>Energy of the touch</source>
        <translation>Energia del tocco</translation>
    </message>
    <message>
        <source>Enough points.</source>
        <translation>Punti sufficienti.</translation>
    </message>
    <message>
        <source>Enter or a double click goes back to a layout.</source>
        <translation>Invio o doppio clic torna a una disposizione.</translation>
    </message>
    <message>
        <source>Enter or a double click opens a session. Two chosen, the second with Ctrl, can be compared.</source>
        <translation>Invio o doppio clic apre una sessione. Due scelte, la seconda con Ctrl, si possono confrontare.</translation>
    </message>
    <message>
        <source>Enter the address and port to listen on, such as 127.0.0.1:3490.</source>
        <translation>Scrivere indirizzo e porta di ascolto, come 127.0.0.1:3490.</translation>
    </message>
    <message>
        <source>Enter the stream's address, such as http://192.168.0.7:8090/.</source>
        <translation>Inserire l’indirizzo del flusso, come http://192.168.0.7:8090/.</translation>
    </message>
    <message>
        <source>Enter the touchpad's address and port, such as 192.168.0.7:502.</source>
        <translation>Inserire indirizzo e porta del touchpad, come 192.168.0.7:502.</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Errore</translation>
    </message>
    <message>
        <source>Error beside, mm</source>
        <translation>Errore a lato, mm</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>Errore, mm</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Errori</translation>
    </message>
    <message>
        <source>Errors by kind</source>
        <translation>Errori per tipo</translation>
    </message>
    <message>
        <source>Errors of the stiffness up to this are left alone (the thesis, in its own mode, 0.01).</source>
        <translation>Gli errori di rigidezza fino a questo valore sono lasciati stare (la tesi, nel suo modo, 0,01).</translation>
    </message>
    <message>
        <source>Esc stops.</source>
        <translation>Esc arresta.</translation>
    </message>
    <message>
        <source>Every parameter takes its saved value again; one step to undo</source>
        <translation>Ogni parametro riprende il valore salvato; un solo passo da annullare</translation>
    </message>
    <message>
        <source>Everything is simulated: time waits for this computer when it is late, %1 s so far, and nothing is Held for it.</source>
        <translation>Tutto è simulato: il tempo aspetta questo computer quando è in ritardo, %1 s finora, e nulla viene Bloccato per questo.</translation>
    </message>
    <message>
        <source>Everything needed is there; motors off.</source>
        <translation>C'è tutto il necessario; motori spenti.</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Esperimento</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Esporta</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>Esporta come CSV</translation>
    </message>
    <message>
        <source>Export as MCAP</source>
        <translation>Esporta come MCAP</translation>
    </message>
    <message>
        <source>Export for MATLAB</source>
        <translation>Esporta per MATLAB</translation>
    </message>
    <message>
        <source>Export the camera's video</source>
        <translation>Esporta il video della telecamera</translation>
    </message>
    <message>
        <source>Export, all or from A to B</source>
        <translation>Esporta, tutto o da A a B</translation>
    </message>
    <message>
        <source>FYD Console</source>
        <translation>FYD Console</translation>
    </message>
    <message>
        <source>FYD Link robot, listening on {}</source>
        <translation>robot FYD Link, in ascolto su {}</translation>
    </message>
    <message>
        <source>FYD Link with a key</source>
        <translation>FYD Link con una chiave</translation>
    </message>
    <message>
        <source>FYD Link, sealed</source>
        <translation>FYD Link, sigillato</translation>
    </message>
    <message>
        <source>Fastest change of the commanded stretch and translation; in mode thesis not of the stretch, unless the robot sets it.</source>
        <translation>Massima velocità della tensione e della traslazione comandate; nel modo thesis non della tensione, a meno che sia il robot a darla.</translation>
    </message>
    <message>
        <source>Fastest the position sent to the robot moves along each axis.</source>
        <translation>Massima velocità, lungo ogni asse, della posizione inviata al robot.</translation>
    </message>
    <message>
        <source>Feel saved or current values</source>
        <translation>Sentire i valori salvati o quelli attuali</translation>
    </message>
    <message>
        <source>Felt, over threshold</source>
        <translation>Sentito, oltre la soglia</translation>
    </message>
    <message>
        <source>Figures between A and B</source>
        <translation>Valori tra A e B</translation>
    </message>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>File %1: expected a name that ends in .h5.</source>
        <translation>File %1: atteso un nome che termina in .h5.</translation>
    </message>
    <message>
        <source>File %1: expected a whole path, from / on.</source>
        <translation>File %1: atteso un percorso completo, da / in poi.</translation>
    </message>
    <message>
        <source>File %1: it is there already; a recording is never written over.</source>
        <translation>File %1: esiste già; una registrazione non viene mai sovrascritta.</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>il file esiste già</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>nome del file troppo lungo</translation>
    </message>
    <message>
        <source>File of the recording</source>
        <translation>File della registrazione</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>il file è troppo grande</translation>
    </message>
    <message>
        <source>File: where is the recording to go?</source>
        <translation>File: dove va la registrazione?</translation>
    </message>
    <message>
        <source>Files written</source>
        <translation>File scritti</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtro</translation>
    </message>
    <message>
        <source>Find a command</source>
        <translation>Trova un comando</translation>
    </message>
    <message>
        <source>Find a command…</source>
        <translation>Trova un comando…</translation>
    </message>
    <message>
        <source>Find a parameter…</source>
        <translation>Trova un parametro…</translation>
    </message>
    <message>
        <source>Finds out how cloth and sensors answer and proposes gains. Nothing changes until you accept.</source>
        <translation>Scopre come rispondono tessuto e sensori e propone guadagni. Nulla cambia finché non si accetta.</translation>
    </message>
    <message>
        <source>Finger</source>
        <translation>Dito</translation>
    </message>
    <message>
        <source>Finger area in square millimetres</source>
        <translation>Area del dito in millimetri quadrati</translation>
    </message>
    <message>
        <source>Finger centre x</source>
        <translation>Centro x del dito</translation>
    </message>
    <message>
        <source>Finger centre y</source>
        <translation>Centro y del dito</translation>
    </message>
    <message>
        <source>Finger found</source>
        <translation>Dito trovato</translation>
    </message>
    <message>
        <source>Finger mask</source>
        <translation>Maschera del dito</translation>
    </message>
    <message>
        <source>Finger minimum area</source>
        <translation>Area minima del dito</translation>
    </message>
    <message>
        <source>Finger minimum contrast</source>
        <translation>Contrasto minimo del dito</translation>
    </message>
    <message>
        <source>Finger mirror</source>
        <translation>Specchio del dito</translation>
    </message>
    <message>
        <source>Finger mode</source>
        <translation>Modo del dito</translation>
    </message>
    <message>
        <source>Finger rotation</source>
        <translation>Rotazione del dito</translation>
    </message>
    <message>
        <source>Finger scale x</source>
        <translation>Scala x del dito</translation>
    </message>
    <message>
        <source>Finger scale y</source>
        <translation>Scala y del dito</translation>
    </message>
    <message>
        <source>Finger smallest contact</source>
        <translation>Contatto minimo del dito</translation>
    </message>
    <message>
        <source>Finger threshold</source>
        <translation>Soglia del dito</translation>
    </message>
    <message>
        <source>Finger x in millimetres</source>
        <translation>x del dito in millimetri</translation>
    </message>
    <message>
        <source>Finger y in millimetres</source>
        <translation>y del dito in millimetri</translation>
    </message>
    <message>
        <source>Finger's area</source>
        <translation>Area del dito</translation>
    </message>
    <message>
        <source>Finger, indentation and force</source>
        <translation>Dito, indentazione e forza</translation>
    </message>
    <message>
        <source>Finger, x</source>
        <translation>Dito, x</translation>
    </message>
    <message>
        <source>Finger, y</source>
        <translation>Dito, y</translation>
    </message>
    <message>
        <source>Finger: %1</source>
        <translation>Dito: %1</translation>
    </message>
    <message>
        <source>First encoder's reading at zero stretch.</source>
        <translation>Lettura del primo encoder a tensione zero.</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Primi passi</translation>
    </message>
    <message>
        <source>First touch</source>
        <translation>Primo tocco</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Adattamento</translation>
    </message>
    <message>
        <source>Fitted</source>
        <translation>Adattato</translation>
    </message>
    <message>
        <source>Folder of pictures</source>
        <translation>Cartella di immagini</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Segui</translation>
    </message>
    <message>
        <source>Follow the newest values</source>
        <translation>Segui i valori più recenti</translation>
    </message>
    <message>
        <source>Follow the newest values (F)</source>
        <translation>Segui i valori più recenti (F)</translation>
    </message>
    <message>
        <source>Follow the stiffness of what the robot touches.</source>
        <translation>Segue la rigidezza di ciò che il robot tocca.</translation>
    </message>
    <message>
        <source>Following</source>
        <translation>Segue</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Forza</translation>
    </message>
    <message>
        <source>Force
N</source>
        <translation>Forza
N</translation>
    </message>
    <message>
        <source>Force %1</source>
        <translation>Forza %1</translation>
    </message>
    <message>
        <source>Force noise</source>
        <translation>Rumore della forza</translation>
    </message>
    <message>
        <source>Force tare sigma</source>
        <translation>Sigma tara della forza</translation>
    </message>
    <message>
        <source>Force the robot tells</source>
        <translation>Forza che il robot dice</translation>
    </message>
    <message>
        <source>Force zero</source>
        <translation>Zero della forza</translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation>Forza, N</translation>
    </message>
    <message>
        <source>Forgets this part's points; the values in force stay.</source>
        <translation>Dimentica i punti di questa parte; i valori in vigore restano.</translation>
    </message>
    <message>
        <source>Format of the file</source>
        <translation>Formato del file</translation>
    </message>
    <message>
        <source>Found in the manual</source>
        <translation>Trovato nel manuale</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Frame</translation>
    </message>
    <message>
        <source>Frequency over time, Hz over s</source>
        <translation>Frequenza nel tempo, Hz su s</translation>
    </message>
    <message>
        <source>Frequency, Hz</source>
        <translation>Frequenza, Hz</translation>
    </message>
    <message>
        <source>From A to B: %1 s to %2 s</source>
        <translation>Da A a B: da %1 s a %2 s</translation>
    </message>
    <message>
        <source>From A to B: a report is of the whole session</source>
        <translation>Da A a B: un rapporto è di tutta la sessione</translation>
    </message>
    <message>
        <source>From A to B: set them with [ and ]</source>
        <translation>Da A a B: metterli con [ e ]</translation>
    </message>
    <message>
        <source>From the last minute of this session</source>
        <translation>Dall'ultimo minuto di questa sessione</translation>
    </message>
    <message>
        <source>From the mean, g</source>
        <translation>Dalla media, g</translation>
    </message>
    <message>
        <source>From the simulated touchpad, 12 s of virtual time</source>
        <translation>Dal touchpad simulato, 12 s di tempo virtuale</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Davanti</translation>
    </message>
    <message>
        <source>Full scale</source>
        <translation>Fondo scala</translation>
    </message>
    <message>
        <source>Gain k_vib</source>
        <translation>Guadagno k_vib</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>Margine di guadagno</translation>
    </message>
    <message>
        <source>Gain of the vibration; the robot's operator moves it by 0.1.</source>
        <translation>Guadagno della vibrazione; l'operatore del robot lo muove di 0,1.</translation>
    </message>
    <message>
        <source>Gesture card for the simulated finger</source>
        <translation>Scheda di gesto per il dito simulato</translation>
    </message>
    <message>
        <source>Gesture card or recorded hand</source>
        <translation>Scheda di gesto o mano registrata</translation>
    </message>
    <message>
        <source>Gesture card …</source>
        <translation>Scheda di gesto …</translation>
    </message>
    <message>
        <source>Gesture cards (*.gesture);;Recorded hands (*.csv);;All files (*)</source>
        <translation>Schede di gesto (*.gesture);;Mani registrate (*.csv);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>Give the chosen preset the name above</source>
        <translation>Dai alla preimpostazione scelta il nome qui sopra</translation>
    </message>
    <message>
        <source>Go on to the heaviest weight, then take the same weights off again one by one.</source>
        <translation>Arrivare al peso maggiore, poi togliere gli stessi pesi uno alla volta.</translation>
    </message>
    <message>
        <source>Go to Operate, hold Arm in the bar above until it acts, then press the cloth with a finger. Esc stops at any time.</source>
        <translation>Andare a Lavoro, tenere premuto il pulsante per armare nella barra in alto finché agisce, poi premere il tessuto con un dito. Esc ferma in ogni momento.</translation>
    </message>
    <message>
        <source>Go to Operate, hold Arm in the bar above until it acts, then press the cloth: with the mouse on the camera's picture.</source>
        <translation>Andare a Lavoro, tenere premuto il pulsante per armare nella barra in alto finché agisce, poi premere il tessuto: col mouse sull’immagine della telecamera.</translation>
    </message>
    <message>
        <source>Go to a time</source>
        <translation>Va' a un tempo</translation>
    </message>
    <message>
        <source>Go to a time of the session</source>
        <translation>Va' a un tempo della sessione</translation>
    </message>
    <message>
        <source>Good: %1.</source>
        <translation>Bene: %1.</translation>
    </message>
    <message>
        <source>Greatest stretch the controller commands.</source>
        <translation>Massima tensione che il controllore comanda.</translation>
    </message>
    <message>
        <source>Grey value</source>
        <translation>Valore di grigio</translation>
    </message>
    <message>
        <source>HDF5 does not take the console's driver</source>
        <translation>HDF5 non accetta il driver della console</translation>
    </message>
    <message>
        <source>Half a second without a hole is needed.</source>
        <translation>Serve mezzo secondo senza buchi.</translation>
    </message>
    <message>
        <source>Half the usable cloth's depth.</source>
        <translation>Metà della profondità utile del tessuto.</translation>
    </message>
    <message>
        <source>Half the usable cloth's width.</source>
        <translation>Metà della larghezza utile del tessuto.</translation>
    </message>
    <message>
        <source>Hand target</source>
        <translation>Obiettivo a mano</translation>
    </message>
    <message>
        <source>Haptic point</source>
        <translation>Punto aptico</translation>
    </message>
    <message>
        <source>Haptic point %1, proxy %2, force %3; %4.</source>
        <translation>Punto aptico %1, proxy %2, forza %3; %4.</translation>
    </message>
    <message>
        <source>Heat limit</source>
        <translation>Limite termico</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altezza</translation>
    </message>
    <message>
        <source>Height of the cloth in the camera's picture.</source>
        <translation>Altezza del tessuto nell'immagine della telecamera.</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Bloccato</translation>
    </message>
    <message>
        <source>Held-out error %1</source>
        <translation>Errore di verifica %1</translation>
    </message>
    <message>
        <source>Held-out error %1 of at most %2</source>
        <translation>Errore di verifica %1 su al più %2</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aiuto</translation>
    </message>
    <message>
        <source>Help for what is in focus</source>
        <translation>Aiuto su ciò che è attivo</translation>
    </message>
    <message>
        <source>Here: %1
Robot: %2
%3 states received, %4 touches sent, %5 datagrams refused</source>
        <translation>Qui: %1
Robot: %2
%3 stati ricevuti, %4 tocchi inviati, %5 datagrammi rifiutati</translation>
    </message>
    <message>
        <source>High-pass in front of the method; thesis is the printed one, with its leak of gravity.</source>
        <translation>Passa-alto prima del metodo; thesis è quello stampato, con la sua fuga di gravità.</translation>
    </message>
    <message>
        <source>Hold Arm to start.</source>
        <translation>Tenere premuto Arma per iniziare.</translation>
    </message>
    <message>
        <source>Hold Re-arm to start again.</source>
        <translation>Tenere premuto Riarma per ricominciare.</translation>
    </message>
    <message>
        <source>Hold a flat white target over the sensor, measure its distance, type it and take the point.</source>
        <translation>Tenere un bersaglio bianco piano sopra il sensore, misurarne la distanza, scriverla e prendere il punto.</translation>
    </message>
    <message>
        <source>Hold for 0.6 s, by mouse or with the space bar, to start rendering: the motors switch on.</source>
        <translation>Tenere premuto 0,6 s, col mouse o con la barra spaziatrice, per iniziare la resa: i motori si accendono.</translation>
    </message>
    <message>
        <source>Hold still.</source>
        <translation>Stare fermi.</translation>
    </message>
    <message>
        <source>Hold the button until the sweep is done, then look at the fit and accept it.</source>
        <translation>Tenere il pulsante fino alla fine della corsa, poi guardare la curva e accettarla.</translation>
    </message>
    <message>
        <source>Hold the picture still; measuring goes on (Space)</source>
        <translation>Ferma l'immagine; la misura continua (Spazio)</translation>
    </message>
    <message>
        <source>Hold the space bar, or the mouse on the button, for 0.6 s to arm.</source>
        <translation>Per armare tenere premuta per 0,6 s la barra spaziatrice, o il mouse sul pulsante.</translation>
    </message>
    <message>
        <source>Hold the stiffness set below, whatever the robot touches.</source>
        <translation>Mantiene la rigidezza impostata sotto, qualunque cosa tocchi il robot.</translation>
    </message>
    <message>
        <source>Hold the vertical ranges</source>
        <translation>Blocca gli intervalli verticali</translation>
    </message>
    <message>
        <source>Hold to arm</source>
        <translation>Tenere: arma</translation>
    </message>
    <message>
        <source>Hold to move</source>
        <translation>Tenere per muovere</translation>
    </message>
    <message>
        <source>Hold to move the motors</source>
        <translation>Tenere premuto per muovere i motori</translation>
    </message>
    <message>
        <source>Hold to re-arm</source>
        <translation>Tenere: riarma</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Iniziale</translation>
    </message>
    <message>
        <source>Hop</source>
        <translation>Avanzamento</translation>
    </message>
    <message>
        <source>How far the time between the robot's messages strays: four mean deviations.</source>
        <translation>Quanto varia il tempo tra i messaggi del robot: quattro deviazioni medie.</translation>
    </message>
    <message>
        <source>How fast the cloth's stiffness may wander while the motors move.</source>
        <translation>Quanto in fretta la rigidezza del tessuto può variare mentre i motori si muovono.</translation>
    </message>
    <message>
        <source>How long accelerations wait (plus up to one period), so that jittery packets still arrive in time; FYD Link raises it to what its batches need.</source>
        <translation>Quanto attendono le accelerazioni (più al massimo un periodo), perché i pacchetti irregolari arrivino ancora in tempo; FYD Link lo alza a quanto serve ai suoi gruppi.</translation>
    </message>
    <message>
        <source>How much a degree of stretch moves the resonance.</source>
        <translation>Di quanto un grado di tensione sposta la risonanza.</translation>
    </message>
    <message>
        <source>How often the robot was silent for longer than the link allows.</source>
        <translation>Quante volte il robot ha taciuto più a lungo di quanto il collegamento permette.</translation>
    </message>
    <message>
        <source>How slowly the measured stiffness follows the true one (time constant); auto-tune measures it.</source>
        <translation>Quanto lentamente la rigidezza misurata segue la vera (costante di tempo); la regolazione automatica la misura.</translation>
    </message>
    <message>
        <source>How the cloth gets its target: direct takes the robot's stiffness as it comes, spring its force over the indentation, tdpa the same within the energy that the finger put in, model keeps an estimate that stiffens out of contact or at another place.</source>
        <translation>Come il tessuto riceve il suo obiettivo: direct prende la rigidezza del robot come arriva, spring la sua forza divisa per l'indentazione, tdpa lo stesso entro l'energia che il dito ha messo, model tiene una stima che s'irrigidisce fuori dal contatto o in un altro luogo.</translation>
    </message>
    <message>
        <source>How the robot's end says where the finger is now; "thesis" follows late and smoothly.</source>
        <translation>Come il lato del robot dice dove si trova ora il dito; "thesis" segue tardi e dolcemente.</translation>
    </message>
    <message>
        <source>How the stretch follows the stiffness target: law and PID, or as the thesis prints it.</source>
        <translation>Come la tensione segue la rigidezza desiderata: legge e PID, o come stampato nella tesi.</translation>
    </message>
    <message>
        <source>How three axes of vibration become one signal.</source>
        <translation>Come tre assi di vibrazione diventano un segnale.</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>IR</source>
        <translation>IR</translation>
    </message>
    <message>
        <source>IR codes {}, expected 0 to {}</source>
        <translation>codici IR {}, attesi da 0 a {}</translation>
    </message>
    <message>
        <source>IR sensor {}</source>
        <translation>Sensore IR {}</translation>
    </message>
    <message>
        <source>IR sensor {} is stuck at code {} while the others change: check its cable</source>
        <translation>il sensore IR {} è fermo al codice {} mentre gli altri cambiano: controllare il suo cavo</translation>
    </message>
    <message>
        <source>Identical, bit for bit, as far as it goes.</source>
        <translation>Identica, bit per bit, fin dove arriva.</translation>
    </message>
    <message>
        <source>Identical, bit for bit.</source>
        <translation>Identica, bit per bit.</translation>
    </message>
    <message>
        <source>Identify cloth and sensors and propose gains; nothing is changed (Ctrl+U)</source>
        <translation>Identifica tessuto e sensori e propone guadagni; nulla cambia (Ctrl+U)</translation>
    </message>
    <message>
        <source>In force</source>
        <translation>In vigore</translation>
    </message>
    <message>
        <source>Inappropriate ioctl for device</source>
        <translation>operazione non adatta al dispositivo</translation>
    </message>
    <message>
        <source>Indentation</source>
        <translation>Indentazione</translation>
    </message>
    <message>
        <source>Indentation holding</source>
        <translation>Indentazione, dito fermo</translation>
    </message>
    <message>
        <source>Indentation mode</source>
        <translation>Modo d'indentazione</translation>
    </message>
    <message>
        <source>Indentation moving</source>
        <translation>Indentazione, dito in moto</translation>
    </message>
    <message>
        <source>Indentation sigma limit</source>
        <translation>Limite sigma indentazione</translation>
    </message>
    <message>
        <source>Indentation, mm</source>
        <translation>Indentazione, mm</translation>
    </message>
    <message>
        <source>Input delay</source>
        <translation>Ritardo d'ingresso</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>errore di ingresso/uscita</translation>
    </message>
    <message>
        <source>Integral gain in thesis mode.</source>
        <translation>Guadagno integrale nel modo thesis.</translation>
    </message>
    <message>
        <source>Integral gain, of the relative error.</source>
        <translation>Guadagno integrale, dell'errore relativo.</translation>
    </message>
    <message>
        <source>Invalid argument</source>
        <translation>argomento non valido</translation>
    </message>
    <message>
        <source>Invalid cross-device link</source>
        <translation>collegamento tra dispositivi non valido</translation>
    </message>
    <message>
        <source>Ir noise</source>
        <translation>Rumore IR</translation>
    </message>
    <message>
        <source>Ir offset</source>
        <translation>Offset IR</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>è una cartella</translation>
    </message>
    <message>
        <source>It cannot be proven bit for bit, a part of the recording is lost: %1</source>
        <translation>Non si può provare bit per bit, una parte della registrazione è persa: %1</translation>
    </message>
    <message>
        <source>It ends at the first of %1 lost samples.</source>
        <translation>Termina al primo di %1 campioni persi.</translation>
    </message>
    <message>
        <source>It is damaged. Recover keeps what can be proven; it can be opened as it is, too.</source>
        <translation>È danneggiata. Recupera conserva ciò che si può provare; si può aprire anche così com'è.</translation>
    </message>
    <message>
        <source>Its recorder crashed, or it is damaged; what can be proven is shown. This makes the recording whole. Nothing is deleted.</source>
        <translation>Il suo registratore si è interrotto, o è danneggiata; si mostra ciò che si può provare. Questo rende integra la registrazione. Nulla viene cancellato.</translation>
    </message>
    <message>
        <source>Its recorder crashed. Recover makes it whole; it can be opened as it is, too.</source>
        <translation>Il suo registratore si è interrotto. Recupera la rende integra; si può aprire anche così com'è.</translation>
    </message>
    <message>
        <source>Its value</source>
        <translation>Il suo valore</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Fluttuazione</translation>
    </message>
    <message>
        <source>KRC control strategy {}: expected Cartesian impedance</source>
        <translation>strategia di controllo KRC {}: attesa impedenza cartesiana</translation>
    </message>
    <message>
        <source>KRC in monitor mode: the arm holds; link quality {}; the program on the controller starts command mode</source>
        <translation>KRC in modo monitor: il braccio sta fermo; qualità del collegamento {}; il programma sul controllore avvia il modo comando</translation>
    </message>
    <message>
        <source>KRC link quality {}: {:.0f} % of its measurements answered; expected good or perfect</source>
        <translation>qualità del collegamento KRC {}: risposto al {:.0f} % delle sue misure; attesa buona o perfetta</translation>
    </message>
    <message>
        <source>KRC off: open FRI in the program on the controller</source>
        <translation>KRC spento: aprire FRI nel programma sul controllore</translation>
    </message>
    <message>
        <source>KRC reports drive errors {:#04x}: acknowledge them on the controller</source>
        <translation>il KRC segnala errori degli azionamenti {:#04x}: confermarli sul controllore</translation>
    </message>
    <message>
        <source>KRC silent for {:.0f} ms; expected a measurement every 1 to 100 ms: cable, or FRI closed</source>
        <translation>KRC in silenzio da {:.0f} ms; attesa una misura ogni 1–100 ms: cavo, o FRI chiuso</translation>
    </message>
    <message>
        <source>KRC: command mode has just begun, the arm holds</source>
        <translation>KRC: il modo comando è appena iniziato, il braccio sta fermo</translation>
    </message>
    <message>
        <source>KRC: commanded and measured frame are {:g} m apart; expected at most {:g} m</source>
        <translation>KRC: i sistemi comandato e misurato distano {:g} m; attesi al più {:g} m</translation>
    </message>
    <message>
        <source>KRC: leap {} mm/s; expected more than 0</source>
        <translation>KRC: balzo di {} mm/s; atteso più di 0</translation>
    </message>
    <message>
        <source>KRC: none of the last {} answers shows in its commanded frame; expected the place that was commanded</source>
        <translation>KRC: nessuna delle ultime {} risposte compare nel suo sistema comandato; attesa la posizione che era stata comandata</translation>
    </message>
    <message>
        <source>KRC: nothing heard on {}; expected a measurement every 1 to 100 ms: is FRI open on the controller?</source>
        <translation>KRC: nulla ricevuto su {}; attesa una misura ogni 1–100 ms: FRI è aperto sul controllore?</translation>
    </message>
    <message>
        <source>KRC: period {} ms; expected 1 to 100</source>
        <translation>KRC: periodo {} ms; atteso da 1 a 100</translation>
    </message>
    <message>
        <source>KRC: target ({}, {}, {}) mm: expected three finite numbers</source>
        <translation>KRC: obiettivo ({}, {}, {}) mm: attesi tre numeri finiti</translation>
    </message>
    <message>
        <source>KRC: the arm is coming to rest</source>
        <translation>KRC: il braccio si sta fermando</translation>
    </message>
    <message>
        <source>KRC: the measured frame moved {:g} m in {} cycles; expected at most {:g} m</source>
        <translation>KRC: il sistema misurato si è mosso di {:g} m in {} cicli; atteso al più {:g} m</translation>
    </message>
    <message>
        <source>KRC: the remote's address {} has no port to send to</source>
        <translation>KRC: l'indirizzo {} del lato remoto non ha una porta a cui inviare</translation>
    </message>
    <message>
        <source>KRC: the rotation of the {} frame is off by {:g}; expected rows of length 1 at right angles, within {}</source>
        <translation>KRC: la rotazione del sistema {} è errata di {:g}; attese righe di lunghezza 1 ad angolo retto, entro {}</translation>
    </message>
    <message>
        <source>KRC: the {} frame is a mirror; expected a rotation (determinant 1)</source>
        <translation>KRC: il sistema {} è speculare; attesa una rotazione (determinante 1)</translation>
    </message>
    <message>
        <source>KRC: the {} frame is at ({:g}, {:g}, {:g}) m; expected within {:g} m of the base</source>
        <translation>KRC: il sistema {} è a ({:g}, {:g}, {:g}) m; atteso entro {:g} m dalla base</translation>
    </message>
    <message>
        <source>KRC: {} cannot reach {}: both must be IPv4 or both IPv6</source>
        <translation>KRC: {} non può raggiungere {}: entrambi devono essere IPv4 o entrambi IPv6</translation>
    </message>
    <message>
        <source>KRC: {} {} is {:g} {}; expected within ±{:g} {}</source>
        <translation>KRC: {} {} è {:g} {}; atteso entro ±{:g} {}</translation>
    </message>
    <message>
        <source>KRL real</source>
        <translation>reale KRL</translation>
    </message>
    <message>
        <source>KUKA LWR over FRI on {}</source>
        <translation>KUKA LWR via FRI su {}</translation>
    </message>
    <message>
        <source>Kalman filter: how much it wanders while the finger presses or lifts.</source>
        <translation>Filtro di Kalman: quanto varia mentre il dito preme o si alza.</translation>
    </message>
    <message>
        <source>Kalman filter: how much the indentation wanders while the finger holds still.</source>
        <translation>Filtro di Kalman: quanto varia l'indentazione mentre il dito sta fermo.</translation>
    </message>
    <message>
        <source>Kd</source>
        <translation>Kd</translation>
    </message>
    <message>
        <source>Keep the present values of all live parameters under this name (Enter)</source>
        <translation>Conserva con questo nome i valori attuali di tutti i parametri dal vivo (Invio)</translation>
    </message>
    <message>
        <source>Keep the value that is in use (Enter)</source>
        <translation>Mantiene il valore in uso (Invio)</translation>
    </message>
    <message>
        <source>Kept beside the recording, which stays as it is; the list of sessions finds them.</source>
        <translation>Conservate accanto alla registrazione, che resta com'è; l'elenco delle sessioni le trova.</translation>
    </message>
    <message>
        <source>Key file</source>
        <translation>File della chiave</translation>
    </message>
    <message>
        <source>Key file of FYD Link</source>
        <translation>File della chiave di FYD Link</translation>
    </message>
    <message>
        <source>Ki</source>
        <translation>Ki</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Kp</source>
        <translation>Kp</translation>
    </message>
    <message>
        <source>Language: English</source>
        <translation>Lingua: inglese</translation>
    </message>
    <message>
        <source>Language: French</source>
        <translation>Lingua: francese</translation>
    </message>
    <message>
        <source>Language: Italian</source>
        <translation>Lingua: italiano</translation>
    </message>
    <message>
        <source>Largest duty that vibration may use.</source>
        <translation>Massimo duty che la vibrazione può usare.</translation>
    </message>
    <message>
        <source>Largest relative correction of the law; a measurement that asks for more contradicts it.</source>
        <translation>Correzione relativa più grande della legge; una misura che chiede di più la contraddice.</translation>
    </message>
    <message>
        <source>Last answer</source>
        <translation>Ultima risposta</translation>
    </message>
    <message>
        <source>Last message</source>
        <translation>Ultimo messaggio</translation>
    </message>
    <message>
        <source>Last picture</source>
        <translation>Ultima immagine</translation>
    </message>
    <message>
        <source>Last touch: %1 given back beyond what was put in, %2 withheld</source>
        <translation>Ultimo tocco: %1 restituiti oltre a quanto messo, %2 trattenuti</translation>
    </message>
    <message>
        <source>Lasting measurement error</source>
        <translation>Errore di misura duraturo</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Più tardi</translation>
    </message>
    <message>
        <source>Lay the printed target on the cloth, click one of its marks in the picture, type where it lies, and take the point.</source>
        <translation>Posare il bersaglio stampato sul tessuto, fare clic su un suo segno nell'immagine, scrivere dove si trova e prendere il punto.</translation>
    </message>
    <message>
        <source>Lay the robot's accelerometer on the cloth, along its motion, and a finger beside it. Then hold the button until the sweep of %1 s is over: at two stretches or more.</source>
        <translation>Posare l'accelerometro del robot sul tessuto, lungo il suo moto, e un dito accanto. Poi tenere premuto il pulsante finché la scansione di %1 s è finita: a due tensioni o più.</translation>
    </message>
    <message>
        <source>Layouts</source>
        <translation>Disposizioni</translation>
    </message>
    <message>
        <source>Layouts…</source>
        <translation>Disposizioni…</translation>
    </message>
    <message>
        <source>Least stretch the controller commands.</source>
        <translation>Minima tensione che il controllore comanda.</translation>
    </message>
    <message>
        <source>Leave as it is</source>
        <translation>Lascia com'è</translation>
    </message>
    <message>
        <source>Leave the cell unloaded, type 0 and take the point.</source>
        <translation>Lasciare la cella scarica, scrivere 0 e prendere il punto.</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Sinistra</translation>
    </message>
    <message>
        <source>Left as it is</source>
        <translation>Lasciato com'è</translation>
    </message>
    <message>
        <source>Left edge of the cloth in the camera's picture.</source>
        <translation>Bordo sinistro del tessuto nell'immagine della telecamera.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Durata</translation>
    </message>
    <message>
        <source>Length
s</source>
        <translation>Durata
s</translation>
    </message>
    <message>
        <source>Length, g</source>
        <translation>Modulo, g</translation>
    </message>
    <message>
        <source>Let go, type the next stretch, hold the button and press to three depths again.</source>
        <translation>Rilasciare, scrivere la tensione seguente, tenere il pulsante e premere di nuovo a tre profondità.</translation>
    </message>
    <message>
        <source>Letting go or Esc switches them off.</source>
        <translation>Lasciarlo o premere Esc li spegne.</translation>
    </message>
    <message>
        <source>Light theme</source>
        <translation>Tema chiaro</translation>
    </message>
    <message>
        <source>Line: grey values of the region. Dashed: the suggested threshold between finger and cloth.</source>
        <translation>Linea: valori di grigio della regione. Tratteggio: la soglia proposta tra dito e tessuto.</translation>
    </message>
    <message>
        <source>Line: new curve. Dashed: the one in force. Crosses: points the others contradict.</source>
        <translation>Linea: nuova curva. Tratteggio: quella in vigore. Croci: punti che gli altri contraddicono.</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Collegamento</translation>
    </message>
    <message>
        <source>List of sessions</source>
        <translation>Elenco delle sessioni</translation>
    </message>
    <message>
        <source>Listen on</source>
        <translation>Ascolta su</translation>
    </message>
    <message>
        <source>Listening on</source>
        <translation>In ascolto su</translation>
    </message>
    <message>
        <source>Lists serial ports and cameras as "fyd devices" does. Nothing that is in use is disturbed.</source>
        <translation>Elenca porte seriali e telecamere come fa "fyd devices". Nulla che sia in uso viene disturbato.</translation>
    </message>
    <message>
        <source>Live parameters, held by the step</source>
        <translation>Parametri dal vivo, tenuti dal passo</translation>
    </message>
    <message>
        <source>Live reading over the last 30 s, with the points taken</source>
        <translation>Lettura dal vivo degli ultimi 30 s, con i punti presi</translation>
    </message>
    <message>
        <source>Live values</source>
        <translation>Valori dal vivo</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Carica</translation>
    </message>
    <message>
        <source>Load cell</source>
        <translation>Cella di carico</translation>
    </message>
    <message>
        <source>Load cell measures</source>
        <translation>La cella di carico misura</translation>
    </message>
    <message>
        <source>Load cell: force that is read with nothing on the cloth; the tare sets it.</source>
        <translation>Cella di carico: forza letta senza nulla sul tessuto; la imposta la tara.</translation>
    </message>
    <message>
        <source>Load cell: grams at 0 mV/V.</source>
        <translation>Cella di carico: grammi a 0 mV/V.</translation>
    </message>
    <message>
        <source>Load cell: grams per mV/V.</source>
        <translation>Cella di carico: grammi per mV/V.</translation>
    </message>
    <message>
        <source>Load cell: how far its zero may be off.</source>
        <translation>Cella di carico: quanto può essere fuori il suo zero.</translation>
    </message>
    <message>
        <source>Load cell: noise of one reading.</source>
        <translation>Cella di carico: rumore di una lettura.</translation>
    </message>
    <message>
        <source>Load cell: readings beyond it are invalid; those at the converter's end always are.</source>
        <translation>Cella di carico: le letture oltre questo valore non sono valide; quelle all'estremo del convertitore non lo sono mai.</translation>
    </message>
    <message>
        <source>Load the chosen preset</source>
        <translation>Carica la preimpostazione scelta</translation>
    </message>
    <message>
        <source>Loading one changes all its values at once; undo takes it back.</source>
        <translation>Caricarne una cambia tutti i suoi valori insieme; Annulla la toglie.</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Cerca di nuovo</translation>
    </message>
    <message>
        <source>Look at its signal</source>
        <translation>Guarda il suo segnale</translation>
    </message>
    <message>
        <source>Look at the devices</source>
        <translation>Guarda i dispositivi</translation>
    </message>
    <message>
        <source>Look at the figures at the right, then accept them or measure again.</source>
        <translation>Guardare i valori a destra, poi accettarli o misurare di nuovo.</translation>
    </message>
    <message>
        <source>Look at the offsets at the right, then accept them or measure again.</source>
        <translation>Guardare gli offset a destra, poi accettarli o misurare di nuovo.</translation>
    </message>
    <message>
        <source>Look at the verdict at the right, then accept it, or add a sweep at another stretch.</source>
        <translation>Guardare il verdetto a destra, poi accettarlo, o aggiungere una scansione a un'altra tensione.</translation>
    </message>
    <message>
        <source>Look at the verdict at the right, then accept it, or add presses.</source>
        <translation>Guardare il verdetto a destra, poi accettarlo, o aggiungere pressioni.</translation>
    </message>
    <message>
        <source>Look for dirt or an object under the cloth; calibrate.</source>
        <translation>Cercare sporco o un oggetto sotto il tessuto; calibrare.</translation>
    </message>
    <message>
        <source>Looked for: %1
%2

It is tried again by itself. Another camera is chosen in Devices.</source>
        <translation>Cercata: %1
%2

Si riprova da sé. Un’altra telecamera si sceglie in Dispositivi.</translation>
    </message>
    <message>
        <source>Looking at cameras …</source>
        <translation>Ricerca delle telecamere …</translation>
    </message>
    <message>
        <source>Looking at serial ports …</source>
        <translation>Ricerca delle porte seriali …</translation>
    </message>
    <message>
        <source>Looking for its touches …</source>
        <translation>Ricerca dei suoi tocchi …</translation>
    </message>
    <message>
        <source>Looking for touches in %1</source>
        <translation>Ricerca dei tocchi in %1</translation>
    </message>
    <message>
        <source>Looking for touches …</source>
        <translation>Ricerca dei tocchi …</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Ciclo</translation>
    </message>
    <message>
        <source>Loss</source>
        <translation>Perdita</translation>
    </message>
    <message>
        <source>Lost: the robot is silent</source>
        <translation>Perso: il robot tace</translation>
    </message>
    <message>
        <source>Lower end of %1</source>
        <translation>Estremo inferiore di %1</translation>
    </message>
    <message>
        <source>MATLAB</source>
        <translation>MATLAB</translation>
    </message>
    <message>
        <source>MCAP, for robotics viewers</source>
        <translation>MCAP, per visori di robotica</translation>
    </message>
    <message>
        <source>MJPEG {}: cannot listen: {}</source>
        <translation>MJPEG {}: ascolto impossibile: {}</translation>
    </message>
    <message>
        <source>Make a gesture card of the chosen touch</source>
        <translation>Fare del tocco scelto una scheda di gesto</translation>
    </message>
    <message>
        <source>Make a gesture card of this touch</source>
        <translation>Fare di questo tocco una scheda di gesto</translation>
    </message>
    <message>
        <source>Makes a recording whole whose recorder crashed or that is damaged. Nothing is deleted.</source>
        <translation>Rende integra una registrazione il cui registratore si è interrotto o che è danneggiata. Nulla viene cancellato.</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manuale</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>Conversione</translation>
    </message>
    <message>
        <source>Mapping felt: a steady signal of less RMS than this is noise and stays silent.</source>
        <translation>Conversione felt: un segnale continuo con RMS minore di questo è rumore e tace.</translation>
    </message>
    <message>
        <source>Mapping felt: largest RMS duty over a second, for the motors' heat.</source>
        <translation>Conversione felt: massimo duty RMS in un secondo, per il calore dei motori.</translation>
    </message>
    <message>
        <source>Mapping felt: stored RMS of the surface, to which the gain is fitted; 0 learns it from the touch.</source>
        <translation>Conversione felt: RMS memorizzato della superficie, al quale si adatta il guadagno; 0 lo impara dal tocco.</translation>
    </message>
    <message>
        <source>Mapping from signal to duty: so that the finger feels it, rounded alike on both sides, or as the thesis prints it.</source>
        <translation>Conversione dal segnale al duty: così che il dito la senta, arrotondata allo stesso modo da entrambi i lati, o come la stampa la tesi.</translation>
    </message>
    <message>
        <source>Mappings symmetric and thesis: duties smaller than this become zero, as the motors would not turn.</source>
        <translation>Conversioni symmetric e thesis: i duty più piccoli di questo diventano zero, perché i motori non girerebbero.</translation>
    </message>
    <message>
        <source>Marked values differ from the profile (Ctrl+S)</source>
        <translation>I valori segnati differiscono dal profilo (Ctrl+S)</translation>
    </message>
    <message>
        <source>Marker %1</source>
        <translation>Marcatore %1</translation>
    </message>
    <message>
        <source>Marker %1 at %2.</source>
        <translation>Marcatore %1 a %2.</translation>
    </message>
    <message>
        <source>Marker into the recording</source>
        <translation>Marcatore nella registrazione</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maschera</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Massimo</translation>
    </message>
    <message>
        <source>Maximum gap</source>
        <translation>Lacuna massima</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Mean of the others, mm</source>
        <translation>Media degli altri, mm</translation>
    </message>
    <message>
        <source>Measured, °</source>
        <translation>Misurato, °</translation>
    </message>
    <message>
        <source>Measured.</source>
        <translation>Misurato.</translation>
    </message>
    <message>
        <source>Measurement delay</source>
        <translation>Tempo morto della misura</translation>
    </message>
    <message>
        <source>Measurement lag</source>
        <translation>Ritardo della misura</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Messaggi</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Metodo</translation>
    </message>
    <message>
        <source>Millimetres per pixel along a picture column.</source>
        <translation>Millimetri per pixel lungo una colonna dell'immagine.</translation>
    </message>
    <message>
        <source>Millimetres per pixel along a picture row.</source>
        <translation>Millimetri per pixel lungo una riga dell'immagine.</translation>
    </message>
    <message>
        <source>Mine …</source>
        <translation>Il mio …</translation>
    </message>
    <message>
        <source>Missing now: %1</source>
        <translation>Manca ora: %1</translation>
    </message>
    <message>
        <source>Modbus TCP {}: cannot listen: {}</source>
        <translation>Modbus TCP {}: ascolto impossibile: {}</translation>
    </message>
    <message>
        <source>Motion depth scale</source>
        <translation>Scala del moto in profondità</translation>
    </message>
    <message>
        <source>Motion scale</source>
        <translation>Scala del moto</translation>
    </message>
    <message>
        <source>Motion speed limit</source>
        <translation>Limite di velocità del moto</translation>
    </message>
    <message>
        <source>Motor 1, °</source>
        <translation>Motore 1, °</translation>
    </message>
    <message>
        <source>Motor 2, °</source>
        <translation>Motore 2, °</translation>
    </message>
    <message>
        <source>Motor board</source>
        <translation>Scheda motori</translation>
    </message>
    <message>
        <source>Motor board (qbmove)</source>
        <translation>Scheda motori (qbmove)</translation>
    </message>
    <message>
        <source>Motors</source>
        <translation>Motori</translation>
    </message>
    <message>
        <source>Motors and cloth answer (closed loop)</source>
        <translation>Motori e tessuto rispondono (anello chiuso)</translation>
    </message>
    <message>
        <source>Motors answer</source>
        <translation>I motori rispondono</translation>
    </message>
    <message>
        <source>Motors off at once (Esc, from everywhere)</source>
        <translation>Motori subito spenti (Esc, da ovunque)</translation>
    </message>
    <message>
        <source>Motors' vibration</source>
        <translation>Vibrazione dei motori</translation>
    </message>
    <message>
        <source>Move the target by some 20 mm, type the new distance and take the next point, 40 to 300 mm.</source>
        <translation>Spostare il bersaglio di circa 20 mm, scrivere la nuova distanza e prendere il punto seguente, da 40 a 300 mm.</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>N/mm</source>
        <translation>N/mm</translation>
    </message>
    <message>
        <source>NaN is no time</source>
        <translation>NaN non è un tempo</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Name of the present layout</source>
        <translation>Nome della disposizione presente</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Nome della preimpostazione</translation>
    </message>
    <message>
        <source>Network (Modbus TCP)</source>
        <translation>Rete (Modbus TCP)</translation>
    </message>
    <message>
        <source>Network is down</source>
        <translation>la rete è spenta</translation>
    </message>
    <message>
        <source>Network is unreachable</source>
        <translation>rete irraggiungibile</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nuovo</translation>
    </message>
    <message>
        <source>Next picture</source>
        <translation>Immagine seguente</translation>
    </message>
    <message>
        <source>Next sample</source>
        <translation>Campione seguente</translation>
    </message>
    <message>
        <source>Next trial</source>
        <translation>Prova seguente</translation>
    </message>
    <message>
        <source>No layout is saved yet. Move the panels and choose the curves as you like them, then write a name.</source>
        <translation>Nessuna disposizione è ancora salvata. Spostare i pannelli e scegliere le curve come si vuole, poi scrivere un nome.</translation>
    </message>
    <message>
        <source>No link</source>
        <translation>Nessun collegamento</translation>
    </message>
    <message>
        <source>No marker: nothing is being recorded. Ctrl+R starts.</source>
        <translation>Nessun marcatore: nulla è in registrazione. Ctrl+R inizia.</translation>
    </message>
    <message>
        <source>No motor is sent further than this from its zero, whatever stretch and translation add up to.</source>
        <translation>Nessun motore è mandato più lontano di così dal suo zero, qualunque sia la somma di tensione e traslazione.</translation>
    </message>
    <message>
        <source>No notes. N writes one at the cursor.</source>
        <translation>Nessuna nota. N ne scrive una al cursore.</translation>
    </message>
    <message>
        <source>No notices. Everything that was said is in the log (Ctrl+L).</source>
        <translation>Nessun avviso. Tutto ciò che è stato detto è nel registro (Ctrl+L).</translation>
    </message>
    <message>
        <source>No parameter is found so. The search looks at name, identifier, help and group.</source>
        <translation>Nessun parametro trovato così. La ricerca guarda nome, identificatore, aiuto e gruppo.</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Nessuna immagine</translation>
    </message>
    <message>
        <source>No picture at the cursor.</source>
        <translation>Nessuna immagine al cursore.</translation>
    </message>
    <message>
        <source>No picture was taken before the cursor.</source>
        <translation>Nessuna immagine è stata presa prima del cursore.</translation>
    </message>
    <message>
        <source>No picture yet.</source>
        <translation>Ancora nessuna immagine.</translation>
    </message>
    <message>
        <source>No pictures were recorded.</source>
        <translation>Nessuna immagine è stata registrata.</translation>
    </message>
    <message>
        <source>No points yet. The values in force stay until you accept new ones.</source>
        <translation>Ancora nessun punto. I valori in vigore restano finché non se ne accettano di nuovi.</translation>
    </message>
    <message>
        <source>No preset yet. Tune what you like to keep, write a name and press Save.</source>
        <translation>Ancora nessuna preimpostazione. Regolare ciò che si vuole conservare, scrivere un nome e premere Salva.</translation>
    </message>
    <message>
        <source>No preset yet; the place Tune saves one</source>
        <translation>Ancora nessuna preimpostazione; il luogo Regola ne salva una</translation>
    </message>
    <message>
        <source>No real-time priority: the system may delay the loop.</source>
        <translation>Nessuna priorità in tempo reale: il sistema può ritardare il ciclo.</translation>
    </message>
    <message>
        <source>No recording was opened yet</source>
        <translation>Nessuna registrazione è ancora stata aperta</translation>
    </message>
    <message>
        <source>No report: %1.</source>
        <translation>Nessun rapporto: %1.</translation>
    </message>
    <message>
        <source>No robot on a network: the target is a scene's, or set by hand.</source>
        <translation>Nessun robot in rete: l'obiettivo è di una scena, o impostato a mano.</translation>
    </message>
    <message>
        <source>No route to host</source>
        <translation>nessun percorso verso l'host</translation>
    </message>
    <message>
        <source>No scene stands where the robot stands. Choose a scene file as the robot, in the link's panel, or start with --robot scene:FILE.</source>
        <translation>Al posto del robot non c'è nessuna scena. Scegliere un file di scena come robot, nel pannello del collegamento, o avviare con --robot scene:FILE.</translation>
    </message>
    <message>
        <source>No scene yet.</source>
        <translation>Ancora nessuna scena.</translation>
    </message>
    <message>
        <source>No sensor of the touchpad answers.</source>
        <translation>Nessun sensore del touchpad risponde.</translation>
    </message>
    <message>
        <source>No serial port and no camera. A touchpad on the network is not searched for: enter its address. Simulated parts work without any.</source>
        <translation>Nessuna porta seriale e nessuna telecamera. Un touchpad in rete non viene cercato: inserirne l’indirizzo. Le parti simulate funzionano senza.</translation>
    </message>
    <message>
        <source>No session has these words.</source>
        <translation>Nessuna sessione ha queste parole.</translation>
    </message>
    <message>
        <source>No session is in the catalogue yet. Record one in Operate (Ctrl+R), or name a recording's file below.</source>
        <translation>Nessuna sessione è ancora nel catalogo. Registrarne una in Lavoro (Ctrl+R), o indicare sotto il file di una registrazione.</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>spazio sul disco esaurito</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>il dispositivo non c'è</translation>
    </message>
    <message>
        <source>No such device or address</source>
        <translation>dispositivo o indirizzo inesistente</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>il file o la cartella non esiste</translation>
    </message>
    <message>
        <source>No trial was begun: nothing is being recorded. Ctrl+R starts.</source>
        <translation>Nessuna prova iniziata: nulla è in registrazione. Ctrl+R inizia.</translation>
    </message>
    <message>
        <source>No trials are planned: start with --trials soft,hard,…</source>
        <translation>Nessuna prova prevista: avviare con --trials soft,hard,…</translation>
    </message>
    <message>
        <source>No-touch offsets</source>
        <translation>Offset a riposo</translation>
    </message>
    <message>
        <source>Noise correlation</source>
        <translation>Correlazione del rumore</translation>
    </message>
    <message>
        <source>Noise gate</source>
        <translation>Soglia di rumore</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nessuno</translation>
    </message>
    <message>
        <source>None: a mean, or points without scatter.</source>
        <translation>Nessuna: una media, o punti senza dispersione.</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>non è una cartella</translation>
    </message>
    <message>
        <source>Not accepted, the old values stay. %1</source>
        <translation>Non accettato, i vecchi valori restano. %1</translation>
    </message>
    <message>
        <source>Not applied yet</source>
        <translation>Non ancora applicato</translation>
    </message>
    <message>
        <source>Not applied yet.</source>
        <translation>Non ancora applicato.</translation>
    </message>
    <message>
        <source>Not armed: {}. {}</source>
        <translation>Non armato: {}. {}</translation>
    </message>
    <message>
        <source>Not connected. %1</source>
        <translation>Non collegato. %1</translation>
    </message>
    <message>
        <source>Not connected; all is as it was. %1.</source>
        <translation>Non collegato; tutto è come prima. %1.</translation>
    </message>
    <message>
        <source>Not connected; the former devices are back. %1.</source>
        <translation>Non collegato; sono tornati i dispositivi precedenti. %1.</translation>
    </message>
    <message>
        <source>Not following: press F</source>
        <translation>Non segue: premere F</translation>
    </message>
    <message>
        <source>Not moved: %1.</source>
        <translation>Nessun movimento: %1.</translation>
    </message>
    <message>
        <source>Not moved: see the entry at the left.</source>
        <translation>Nessun movimento: vedere il campo a sinistra.</translation>
    </message>
    <message>
        <source>Not recording. %1.</source>
        <translation>Nessuna registrazione. %1.</translation>
    </message>
    <message>
        <source>Not recording. Folder %1 cannot be made: choose another file.</source>
        <translation>Nessuna registrazione. La cartella %1 non si può creare: scegliere un altro file.</translation>
    </message>
    <message>
        <source>Not secured</source>
        <translation>Non protetto</translation>
    </message>
    <message>
        <source>Not taken: %1.</source>
        <translation>Non preso: %1.</translation>
    </message>
    <message>
        <source>Not taken: %1. Wait until it rests and take the point again.</source>
        <translation>Non preso: %1. Attendere che sia fermo e riprendere il punto.</translation>
    </message>
    <message>
        <source>Not taken: a tare came in between. Take the point again.</source>
        <translation>Non preso: nel frattempo è arrivata una tara. Riprendere il punto.</translation>
    </message>
    <message>
        <source>Not taken: see the entry at the left.</source>
        <translation>Non preso: vedere il campo a sinistra.</translation>
    </message>
    <message>
        <source>Not yet: %1.</source>
        <translation>Non ancora: %1.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>Note at the cursor</source>
        <translation>Nota al cursore</translation>
    </message>
    <message>
        <source>Note at the cursor, then Enter</source>
        <translation>Nota al cursore, poi Invio</translation>
    </message>
    <message>
        <source>Note in the recording: %1</source>
        <translation>Nota nella registrazione: %1</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Notes and events</source>
        <translation>Note ed eventi</translation>
    </message>
    <message>
        <source>Notes: %1 characters are too many; at most %2.</source>
        <translation>Note: %1 caratteri sono troppi; al più %2.</translation>
    </message>
    <message>
        <source>Nothing differs from the profile (Ctrl+S)</source>
        <translation>Nulla differisce dal profilo (Ctrl+S)</translation>
    </message>
    <message>
        <source>Nothing differs from the saved profile. Change a value at the left and it is listed here; A and B then switch between saved and current while you feel.</source>
        <translation>Nulla differisce dal profilo salvato. Cambiare un valore a sinistra e comparirà qui; A e B passano allora dal salvato all'attuale mentre si sente.</translation>
    </message>
    <message>
        <source>Nothing differs from the saved values</source>
        <translation>Nulla differisce dai valori salvati</translation>
    </message>
    <message>
        <source>Nothing in the manual has these words.</source>
        <translation>Nulla nel manuale ha queste parole.</translation>
    </message>
    <message>
        <source>Nothing is checked or hidden: whoever reaches this address can pose as the robot. Use it on a line of its own.</source>
        <translation>Nulla è controllato o nascosto: chi raggiunge questo indirizzo può fingersi il robot. Usarlo su una linea riservata.</translation>
    </message>
    <message>
        <source>Nothing is checked or hidden; only programs on this computer reach it.</source>
        <translation>Nulla è controllato o nascosto; solo i programmi di questo computer vi arrivano.</translation>
    </message>
    <message>
        <source>Nothing is running here.</source>
        <translation>Qui non è in corso nulla.</translation>
    </message>
    <message>
        <source>Nothing is written. %1. Mend or move that file.</source>
        <translation>Non viene scritto nulla. %1. Correggere o spostare quel file.</translation>
    </message>
    <message>
        <source>Nothing of %1 can be read; it is left as it is: %2</source>
        <translation>Di %1 non si può leggere nulla; resta com'è: %2</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>Nulla da ripetere</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>Nulla da annullare</translation>
    </message>
    <message>
        <source>Notice</source>
        <translation>Avviso</translation>
    </message>
    <message>
        <source>Notices</source>
        <translation>Avvisi</translation>
    </message>
    <message>
        <source>Of a difference from the law: excess corrects what exceeds the lasting error, bounded twice that, at most all of it: never worse than the law alone either way.</source>
        <translation>Di una differenza dalla legge: excess corregge ciò che supera l'errore che può durare, bounded il doppio di quello, al più tutta: in entrambi i casi mai peggio della sola legge.</translation>
    </message>
    <message>
        <source>Off: each curve is moved and zoomed by itself (T)</source>
        <translation>Disattivato: ogni curva si sposta e si ingrandisce da sola (T)</translation>
    </message>
    <message>
        <source>Offset, mm</source>
        <translation>Offset, mm</translation>
    </message>
    <message>
        <source>Oldest distance reading the step still trusts.</source>
        <translation>Età massima di una lettura di distanza di cui il passo si fida ancora.</translation>
    </message>
    <message>
        <source>Oldest encoder reading the step still trusts.</source>
        <translation>Età massima di una lettura degli encoder di cui il passo si fida ancora.</translation>
    </message>
    <message>
        <source>Oldest load-cell reading the step still trusts.</source>
        <translation>Età massima di una lettura della cella di carico di cui il passo si fida ancora.</translation>
    </message>
    <message>
        <source>Oldest picture the step still trusts.</source>
        <translation>Età massima di un'immagine di cui il passo si fida ancora.</translation>
    </message>
    <message>
        <source>On a cloth 30 % softer than its law says, with the sensors that the profile describes. Auto-tune finds out more.</source>
        <translation>Su un tessuto 30 % più morbido di quanto dice la sua legge, con i sensori descritti dal profilo. La regolazione automatica ne scopre di più.</translation>
    </message>
    <message>
        <source>On the cloth that auto-tune identified, 30 % softer than its law says.</source>
        <translation>Sul tessuto identificato dalla regolazione automatica, 30 % più morbido di quanto dice la sua legge.</translation>
    </message>
    <message>
        <source>One measurement of %1 s.</source>
        <translation>Una misura di %1 s.</translation>
    </message>
    <message>
        <source>One measurement of 3 s.</source>
        <translation>Una misura di 3 s.</translation>
    </message>
    <message>
        <source>One sweep of at least %1° with 5 angles.</source>
        <translation>Una corsa di almeno %1° con 5 angoli.</translation>
    </message>
    <message>
        <source>One time for all curves</source>
        <translation>Un solo tempo per tutte le curve</translation>
    </message>
    <message>
        <source>Only a robot with the same key is heard; what is said cannot be read or changed.</source>
        <translation>Si ascolta solo un robot con la stessa chiave; ciò che si dice non si può leggere né cambiare.</translation>
    </message>
    <message>
        <source>Only what differs</source>
        <translation>Solo ciò che differisce</translation>
    </message>
    <message>
        <source>Only while nothing renders: press Esc first.</source>
        <translation>Solo mentre nulla è reso: premere prima Esc.</translation>
    </message>
    <message>
        <source>Only with motors that answer.</source>
        <translation>Solo con motori che rispondono.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Apri</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Apri un file…</translation>
    </message>
    <message>
        <source>Open a recording…</source>
        <translation>Apri una registrazione…</translation>
    </message>
    <message>
        <source>Open loop: the recorded inputs as they were; the cloth does not answer.</source>
        <translation>Anello aperto: gli ingressi registrati com'erano; il tessuto non risponde.</translation>
    </message>
    <message>
        <source>Opened lately</source>
        <translation>Aperte di recente</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>Lavoro</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>operazione non consentita</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Operatore</translation>
    </message>
    <message>
        <source>Operator: expected one line of at most %1 characters.</source>
        <translation>Operatore: attesa una riga di al più %1 caratteri.</translation>
    </message>
    <message>
        <source>Operator: who operates? A name or initials.</source>
        <translation>Operatore: chi conduce? Un nome o le iniziali.</translation>
    </message>
    <message>
        <source>Other devices are being connected …</source>
        <translation>Si collegano altri dispositivi …</translation>
    </message>
    <message>
        <source>Other devices are connected: calibration points of the former ones are discarded (%1).</source>
        <translation>Sono collegati altri dispositivi: i punti di calibrazione di quelli precedenti sono scartati (%1).</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Sovraelongazione</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>Pagina del manuale</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Pannelli</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parametro</translation>
    </message>
    <message>
        <source>Parameter %1</source>
        <translation>Parametro %1</translation>
    </message>
    <message>
        <source>Parameter to change</source>
        <translation>Parametro da cambiare</translation>
    </message>
    <message>
        <source>Parts and link</source>
        <translation>Parti e collegamento</translation>
    </message>
    <message>
        <source>Parts and the age of their calibration</source>
        <translation>Parti ed età della loro calibrazione</translation>
    </message>
    <message>
        <source>Path of a recording</source>
        <translation>Percorso di una registrazione</translation>
    </message>
    <message>
        <source>Path of a recording, such as %1</source>
        <translation>Percorso di una registrazione, come %1</translation>
    </message>
    <message>
        <source>Path of a second recording</source>
        <translation>Percorso di una seconda registrazione</translation>
    </message>
    <message>
        <source>Path of a second recording, then Enter</source>
        <translation>Percorso di una seconda registrazione, poi Invio</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Pause or follow</source>
        <translation>Pausa o segui</translation>
    </message>
    <message>
        <source>Paused by the robot</source>
        <translation>Messo in pausa dal robot</translation>
    </message>
    <message>
        <source>Period of the thesis' control law.</source>
        <translation>Periodo della legge di controllo della tesi.</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>permesso negato</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>Margine di fase</translation>
    </message>
    <message>
        <source>Picture column of the touchpad's origin.</source>
        <translation>Colonna dell'immagine dell'origine del touchpad.</translation>
    </message>
    <message>
        <source>Picture row of the touchpad's origin.</source>
        <translation>Riga dell'immagine dell'origine del touchpad.</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Immagini</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Luoghi</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Riproduci</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Riproduci o pausa</translation>
    </message>
    <message>
        <source>Play or pause (Space)</source>
        <translation>Riproduci o pausa (Spazio)</translation>
    </message>
    <message>
        <source>Plugged in</source>
        <translation>Collegati</translation>
    </message>
    <message>
        <source>Point %1 taken.</source>
        <translation>Punto %1 preso.</translation>
    </message>
    <message>
        <source>Points as the simulated touchpad gives them; the record says that they are simulated.</source>
        <translation>Punti come li dà il touchpad simulato; il verbale dice che sono simulati.</translation>
    </message>
    <message>
        <source>Points discarded; the values in force stay.</source>
        <translation>Punti scartati; i valori in vigore restano.</translation>
    </message>
    <message>
        <source>Points taken</source>
        <translation>Punti presi</translation>
    </message>
    <message>
        <source>Points, fit and residuals</source>
        <translation>Punti, adattamento e residui</translation>
    </message>
    <message>
        <source>Position sent</source>
        <translation>Posizione inviata</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>Previsto</translation>
    </message>
    <message>
        <source>Predicted ahead</source>
        <translation>Previsto in avanti</translation>
    </message>
    <message>
        <source>Prediction error</source>
        <translation>Scarto constatato</translation>
    </message>
    <message>
        <source>Predictor</source>
        <translation>Predittore</translation>
    </message>
    <message>
        <source>Present</source>
        <translation>Attuale</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Preimpostazioni</translation>
    </message>
    <message>
        <source>Press Esc, then restart the program.</source>
        <translation>Premere Esc, poi riavviare il programma.</translation>
    </message>
    <message>
        <source>Press over distance sensor %1 once more, twice as deep and at least %2.</source>
        <translation>Premere ancora una volta sopra il sensore di distanza %1, a una profondità doppia e di almeno %2.</translation>
    </message>
    <message>
        <source>Press over distance sensor %1, some 3 mm deep.</source>
        <translation>Premere sopra il sensore di distanza %1, a circa 3 mm di profondità.</translation>
    </message>
    <message>
        <source>Press the cloth now, and hold the depth for a second.</source>
        <translation>Premere ora il tessuto e tenere la profondità per un secondo.</translation>
    </message>
    <message>
        <source>Previous picture</source>
        <translation>Immagine precedente</translation>
    </message>
    <message>
        <source>Previous sample</source>
        <translation>Campione precedente</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problema</translation>
    </message>
    <message>
        <source>Profile not saved. %1</source>
        <translation>Profilo non salvato. %1</translation>
    </message>
    <message>
        <source>Profile saved to %1.</source>
        <translation>Profilo salvato in %1.</translation>
    </message>
    <message>
        <source>Progress of auto-tune</source>
        <translation>Avanzamento della regolazione automatica</translation>
    </message>
    <message>
        <source>Proportional gain in thesis mode.</source>
        <translation>Guadagno proporzionale nel modo thesis.</translation>
    </message>
    <message>
        <source>Proportional gain: relative correction for relative error.</source>
        <translation>Guadagno proporzionale: correzione relativa per errore relativo.</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>Proposto</translation>
    </message>
    <message>
        <source>Proposed values</source>
        <translation>Valori proposti</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protocollo</translation>
    </message>
    <message>
        <source>Proxy</source>
        <translation>Proxy</translation>
    </message>
    <message>
        <source>Put the cursor somewhere and press [ for A, elsewhere and press ] for B.</source>
        <translation>Mettere il cursore da qualche parte e premere [ per A, altrove e premere ] per B.</translation>
    </message>
    <message>
        <source>Put the next known weight on the cell, type it, wait until it rests, take the point.</source>
        <translation>Mettere sulla cella il peso noto seguente, scriverlo, attendere che sia fermo, prendere il punto.</translation>
    </message>
    <message>
        <source>Put the robot to rest with its tool in the air, and take the point: it lasts 3 s.</source>
        <translation>Mettere il robot a riposo con l'utensile in aria e prendere il punto: dura 3 s.</translation>
    </message>
    <message>
        <source>Puts it into the form; nothing is connected yet.</source>
        <translation>Lo mette nel modulo; ancora nulla viene collegato.</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Esci</translation>
    </message>
    <message>
        <source>Quit? Now: %1. Quitting stops the motors and closes the recording; what is not finished is lost. Ctrl+Q again quits.</source>
        <translation>Uscire? Ora: %1. Uscendo si fermano i motori e si chiude la registrazione; ciò che non è finito va perso. Ancora Ctrl+Q esce.</translation>
    </message>
    <message>
        <source>REC %1</source>
        <translation>REC %1</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Radius of the finger's contact with the cloth where no area tells it.</source>
        <translation>Raggio del contatto del dito con il tessuto quando nessuna area lo dice.</translation>
    </message>
    <message>
        <source>Radius of the rollers, cloth included.</source>
        <translation>Raggio dei rulli, tessuto compreso.</translation>
    </message>
    <message>
        <source>Rate at which the texture step is called and its filters are designed.</source>
        <translation>Frequenza con cui il passo della texture è chiamato e per cui sono progettati i suoi filtri.</translation>
    </message>
    <message>
        <source>Rate limit</source>
        <translation>Limite di velocità</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Letto</translation>
    </message>
    <message>
        <source>Read back</source>
        <translation>Riletto</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>file system di sola lettura</translation>
    </message>
    <message>
        <source>Readiness</source>
        <translation>Prontezza</translation>
    </message>
    <message>
        <source>Readiness list</source>
        <translation>Elenco di prontezza</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lettura</translation>
    </message>
    <message>
        <source>Reading the scene. The present session goes on until it is read.</source>
        <translation>Lettura della scena in corso. La sessione attuale continua finché non è letta.</translation>
    </message>
    <message>
        <source>Reading, counts</source>
        <translation>Lettura, cont.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Pronto</translation>
    </message>
    <message>
        <source>Ready? %1/%2</source>
        <translation>Pronto? %1/%2</translation>
    </message>
    <message>
        <source>Ready? Waiting for the station</source>
        <translation>Pronto? In attesa della stazione</translation>
    </message>
    <message>
        <source>Real-time priority granted.</source>
        <translation>Priorità in tempo reale concessa.</translation>
    </message>
    <message>
        <source>Received</source>
        <translation>Ricevuti</translation>
    </message>
    <message>
        <source>Reckoning between A and B</source>
        <translation>Calcolo tra A e B</translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation>Ricollega</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Registra</translation>
    </message>
    <message>
        <source>Record this session into a file (Ctrl+R)</source>
        <translation>Registra questa sessione in un file (Ctrl+R)</translation>
    </message>
    <message>
        <source>Recorded sessions</source>
        <translation>Sessioni registrate</translation>
    </message>
    <message>
        <source>Recorded with arithmetic %1, replayed with %2: the bits cannot be the same.</source>
        <translation>Registrato con l'aritmetica %1, rieseguito con la %2: i bit non possono essere gli stessi.</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Registrazione</translation>
    </message>
    <message>
        <source>Recording closed: %1.</source>
        <translation>Registrazione chiusa: %1.</translation>
    </message>
    <message>
        <source>Recording failed
Press to read why</source>
        <translation>Registrazione fallita
Premere per leggere perché</translation>
    </message>
    <message>
        <source>Recording failed. %1</source>
        <translation>Registrazione fallita. %1</translation>
    </message>
    <message>
        <source>Recording into %1.</source>
        <translation>Registrazione in %1.</translation>
    </message>
    <message>
        <source>Recording to compare with</source>
        <translation>Registrazione con cui confrontare</translation>
    </message>
    <message>
        <source>Recording to open</source>
        <translation>Registrazione da aprire</translation>
    </message>
    <message>
        <source>Recording, played back</source>
        <translation>Registrazione, riprodotta</translation>
    </message>
    <message>
        <source>Recordings (*.h5 *.h5.partial *.h5.damaged*);;All files (*)</source>
        <translation>Registrazioni (*.h5 *.h5.partial *.h5.damaged*);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>Recordings (*.h5)</source>
        <translation>Registrazioni (*.h5)</translation>
    </message>
    <message>
        <source>Recordings (*.h5);;All files (*)</source>
        <translation>Registrazioni (*.h5);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>Record…</source>
        <translation>Registra…</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Recupera</translation>
    </message>
    <message>
        <source>Recover a crashed recording</source>
        <translation>Recupera una registrazione interrotta</translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation>Recupero di %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Ripeti</translation>
    </message>
    <message>
        <source>Redo %1 (Ctrl+Shift+Z)</source>
        <translation>Ripeti %1 (Ctrl+Shift+Z)</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Rifiutati: %1</translation>
    </message>
    <message>
        <source>Refused: %1.</source>
        <translation>Rifiutato: %1.</translation>
    </message>
    <message>
        <source>Refused: none</source>
        <translation>Rifiutati: nessuno</translation>
    </message>
    <message>
        <source>Relative error of the measured stiffness that may last; what is corrected beyond it control.correction says.</source>
        <translation>Errore relativo della rigidezza misurata che può durare; che cosa si corregge oltre lo dice control.correction.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Rinomina</translation>
    </message>
    <message>
        <source>Rename the chosen preset</source>
        <translation>Rinomina la preimpostazione scelta</translation>
    </message>
    <message>
        <source>Rendering; motors on.</source>
        <translation>Resa in corso; motori accesi.</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapporto</translation>
    </message>
    <message>
        <source>Report as PDF</source>
        <translation>Rapporto come PDF</translation>
    </message>
    <message>
        <source>Report as web page</source>
        <translation>Rapporto come pagina web</translation>
    </message>
    <message>
        <source>Report written to %1.</source>
        <translation>Rapporto scritto in %1.</translation>
    </message>
    <message>
        <source>Reset %1 to its default</source>
        <translation>Riporta %1 al valore predefinito</translation>
    </message>
    <message>
        <source>Residual, Hz</source>
        <translation>Residuo, Hz</translation>
    </message>
    <message>
        <source>Residual, N</source>
        <translation>Residuo, N</translation>
    </message>
    <message>
        <source>Residual, mm</source>
        <translation>Residuo, mm</translation>
    </message>
    <message>
        <source>Residual, °</source>
        <translation>Residuo, °</translation>
    </message>
    <message>
        <source>Resonance of the cloth with a finger on it, at the stretch below.</source>
        <translation>Risonanza del tessuto con un dito sopra, alla tensione indicata sotto.</translation>
    </message>
    <message>
        <source>Resonance, Hz</source>
        <translation>Risonanza, Hz</translation>
    </message>
    <message>
        <source>Resource temporarily unavailable</source>
        <translation>risorsa temporaneamente non disponibile</translation>
    </message>
    <message>
        <source>Rest a finger on the cloth, drag a rectangle around the cloth in the picture, and take the point.</source>
        <translation>Appoggiare un dito sul tessuto, trascinare un rettangolo attorno al tessuto nell'immagine e prendere il punto.</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Revisione</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Destra</translation>
    </message>
    <message>
        <source>Rise time</source>
        <translation>Tempo di salita</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Robot connected</source>
        <translation>Robot connesso</translation>
    </message>
    <message>
        <source>Robot's position</source>
        <translation>Posizione del robot</translation>
    </message>
    <message>
        <source>Robot's travel downward for the finger's indentation.</source>
        <translation>Corsa del robot verso il basso per l'indentazione del dito.</translation>
    </message>
    <message>
        <source>Robot's travel for the finger's along the cloth.</source>
        <translation>Corsa del robot per quella del dito lungo il tessuto.</translation>
    </message>
    <message>
        <source>Robot: %1 …</source>
        <translation>Robot: %1 …</translation>
    </message>
    <message>
        <source>Robot…</source>
        <translation>Robot…</translation>
    </message>
    <message>
        <source>Round trip</source>
        <translation>Andata e ritorno</translation>
    </message>
    <message>
        <source>Run again</source>
        <translation>Riesegui</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>In funzione</translation>
    </message>
    <message>
        <source>Running %1 again</source>
        <translation>Nuova esecuzione di %1</translation>
    </message>
    <message>
        <source>Running …</source>
        <translation>In corso …</translation>
    </message>
    <message>
        <source>Runs the recorded inputs through the step again. Without a change it proves that the recording comes out the same, bit for bit.</source>
        <translation>Fa ripassare gli ingressi registrati attraverso il passo. Senza modifiche prova che la registrazione risulta la stessa, bit per bit.</translation>
    </message>
    <message>
        <source>SIMULATED: %1</source>
        <translation>SIMULATO: %1</translation>
    </message>
    <message>
        <source>Samples in a frame of dft321: more resolution for more delay.</source>
        <translation>Campioni in un frame di dft321: più risoluzione per più ritardo.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Salva</translation>
    </message>
    <message>
        <source>Save a preset…</source>
        <translation>Salva una preimpostazione…</translation>
    </message>
    <message>
        <source>Save layout</source>
        <translation>Salva la disposizione</translation>
    </message>
    <message>
        <source>Save profile</source>
        <translation>Salva il profilo</translation>
    </message>
    <message>
        <source>Save the curves as PDF</source>
        <translation>Salva le curve come PDF</translation>
    </message>
    <message>
        <source>Save the curves as PNG</source>
        <translation>Salva le curve come PNG</translation>
    </message>
    <message>
        <source>Save the curves as SVG</source>
        <translation>Salva le curve come SVG</translation>
    </message>
    <message>
        <source>Save the values shown as CSV</source>
        <translation>Salva i valori mostrati come CSV</translation>
    </message>
    <message>
        <source>Saved layouts</source>
        <translation>Disposizioni salvate</translation>
    </message>
    <message>
        <source>Saved profile</source>
        <translation>Profilo salvato</translation>
    </message>
    <message>
        <source>Scale of the colours</source>
        <translation>Scala dei colori</translation>
    </message>
    <message>
        <source>Scale of the spectrum</source>
        <translation>Scala dello spettro</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scena</translation>
    </message>
    <message>
        <source>Scene file</source>
        <translation>File della scena</translation>
    </message>
    <message>
        <source>Scene panel</source>
        <translation>Pannello della scena</translation>
    </message>
    <message>
        <source>Scenes (*.toml);;All files (*)</source>
        <translation>Scene (*.toml);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>Search for devices</source>
        <translation>Cerca dispositivi</translation>
    </message>
    <message>
        <source>Search operator, subject, notes, tags</source>
        <translation>Cerca operatore, soggetto, note, etichette</translation>
    </message>
    <message>
        <source>Search parameters</source>
        <translation>Cerca parametri</translation>
    </message>
    <message>
        <source>Search the log</source>
        <translation>Cerca nel registro</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Cerca nel manuale</translation>
    </message>
    <message>
        <source>Searching …</source>
        <translation>Ricerca …</translation>
    </message>
    <message>
        <source>Second encoder's reading at zero stretch.</source>
        <translation>Lettura del secondo encoder a tensione zero.</translation>
    </message>
    <message>
        <source>Secured</source>
        <translation>Protetto</translation>
    </message>
    <message>
        <source>Selected values back to saved</source>
        <translation>Riporta i valori scelti a quelli salvati</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensore</translation>
    </message>
    <message>
        <source>Sensors live, motors off.</source>
        <translation>Sensori vivi, motori spenti.</translation>
    </message>
    <message>
        <source>Sensors nearer to one line than this condition number make no plane.</source>
        <translation>Sensori più vicini a una retta di questo numero di condizionamento non fanno un piano.</translation>
    </message>
    <message>
        <source>Sent</source>
        <translation>Inviati</translation>
    </message>
    <message>
        <source>Serial line (Modbus RTU)</source>
        <translation>Linea seriale (Modbus RTU)</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>Porta seriale</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sessione</translation>
    </message>
    <message>
        <source>Session time in seconds, 83.5, or minutes and seconds, 1:23.5; then Enter (J)</source>
        <translation>Tempo della sessione in secondi, 83,5, o minuti e secondi, 1:23,5; poi Invio (J)</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sessioni</translation>
    </message>
    <message>
        <source>Set A</source>
        <translation>Imposta A</translation>
    </message>
    <message>
        <source>Set A at the cursor</source>
        <translation>Metti A al cursore</translation>
    </message>
    <message>
        <source>Set B</source>
        <translation>Imposta B</translation>
    </message>
    <message>
        <source>Set B at the cursor</source>
        <translation>Metti B al cursore</translation>
    </message>
    <message>
        <source>Set it aside</source>
        <translation>Metti da parte</translation>
    </message>
    <message>
        <source>Set the target by hand</source>
        <translation>Imposta l'obiettivo a mano</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Impostazione</translation>
    </message>
    <message>
        <source>Settled
s</source>
        <translation>Assestato
s</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>Tempo di assestamento</translation>
    </message>
    <message>
        <source>Share of the robot's messages of the last second that did not arrive.</source>
        <translation>Quota dei messaggi del robot dell'ultimo secondo che non sono arrivati.</translation>
    </message>
    <message>
        <source>Share of the vibration</source>
        <translation>Quota della vibrazione</translation>
    </message>
    <message>
        <source>Shift and drag changes the depth, too</source>
        <translation>Anche Shift e trascinamento cambiano la profondità</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>Mostra %1</translation>
    </message>
    <message>
        <source>Show %1 seconds</source>
        <translation>Mostra %1 secondi</translation>
    </message>
    <message>
        <source>Show 10 s</source>
        <translation>Mostra 10 s</translation>
    </message>
    <message>
        <source>Show 30 s</source>
        <translation>Mostra 30 s</translation>
    </message>
    <message>
        <source>Show 5 s</source>
        <translation>Mostra 5 s</translation>
    </message>
    <message>
        <source>Show 60 s</source>
        <translation>Mostra 60 s</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Mostra nella cartella</translation>
    </message>
    <message>
        <source>Show only parameters that differ from the saved profile</source>
        <translation>Mostra solo i parametri che differiscono dal profilo salvato</translation>
    </message>
    <message>
        <source>Show the last %1 s</source>
        <translation>Mostra gli ultimi %1 s</translation>
    </message>
    <message>
        <source>Show the link</source>
        <translation>Mostra il collegamento</translation>
    </message>
    <message>
        <source>Show the next unread notice</source>
        <translation>Mostra il prossimo avviso non letto</translation>
    </message>
    <message>
        <source>Show the whole scene from this side (%1)</source>
        <translation>Mostra tutta la scena da questo lato (%1)</translation>
    </message>
    <message>
        <source>Show the whole session</source>
        <translation>Mostra tutta la sessione</translation>
    </message>
    <message>
        <source>Signal of the spectrum</source>
        <translation>Segnale dello spettro</translation>
    </message>
    <message>
        <source>Signal that asks for the largest duty (s_max of the thesis).</source>
        <translation>Segnale che chiede il duty massimo (s_max della tesi).</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simulato</translation>
    </message>
    <message>
        <source>Simulated finger: %1</source>
        <translation>Dito simulato: %1</translation>
    </message>
    <message>
        <source>Simulated or mine?</source>
        <translation>Simulato o il mio?</translation>
    </message>
    <message>
        <source>Simulated points, from the simulator's own truth and noise. No part was measured.</source>
        <translation>Punti simulati, dalla verità e dal rumore del simulatore. Nessuna parte è stata misurata.</translation>
    </message>
    <message>
        <source>Simulated points.</source>
        <translation>Punti simulati.</translation>
    </message>
    <message>
        <source>Simulated: %1</source>
        <translation>Simulato: %1</translation>
    </message>
    <message>
        <source>Simulated: %1. What it shows is computed in this program, not measured on a touchpad.</source>
        <translation>Simulato: %1. Ciò che si vede è calcolato in questo programma, non misurato su un touchpad.</translation>
    </message>
    <message>
        <source>Simulated: press on the picture, %1 deep; the wheel changes it.</source>
        <translation>Simulato: premere sull'immagine, a fondo %1; la rotella lo cambia.</translation>
    </message>
    <message>
        <source>Since then it is back. Hold Re-arm to start again.</source>
        <translation>Nel frattempo è tornato tutto. Tenere premuto Riarma per ricominciare.</translation>
    </message>
    <message>
        <source>Slope
per s</source>
        <translation>Pendenza
al s</translation>
    </message>
    <message>
        <source>Small and slow, and only while the button is held. Esc ends it as well.</source>
        <translation>Piccolo e lento, e solo finché il pulsante è premuto. Anche Esc lo termina.</translation>
    </message>
    <message>
        <source>Small video</source>
        <translation>Video piccolo</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Cedevolezza</translation>
    </message>
    <message>
        <source>Something needed went missing.</source>
        <translation>È venuto a mancare qualcosa di necessario.</translation>
    </message>
    <message>
        <source>Spectrum of the vibration</source>
        <translation>Spettro della vibrazione</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocità</translation>
    </message>
    <message>
        <source>Speed of playing</source>
        <translation>Velocità di riproduzione</translation>
    </message>
    <message>
        <source>Speed of the roller at full duty without load.</source>
        <translation>Velocità del rullo a duty pieno senza carico.</translation>
    </message>
    <message>
        <source>Spread, counts</source>
        <translation>Dispersione, cont.</translation>
    </message>
    <message>
        <source>Spread, mV/V</source>
        <translation>Dispersione, mV/V</translation>
    </message>
    <message>
        <source>Stale file handle</source>
        <translation>riferimento a un file non più valido</translation>
    </message>
    <message>
        <source>Standard layout</source>
        <translation>Disposizione standard</translation>
    </message>
    <message>
        <source>Start
s</source>
        <translation>Inizio
s</translation>
    </message>
    <message>
        <source>Start recording</source>
        <translation>Inizia la registrazione</translation>
    </message>
    <message>
        <source>Start the robot's program again.</source>
        <translation>Riavviare il programma del robot.</translation>
    </message>
    <message>
        <source>Start the robot's program, or set the target by hand.</source>
        <translation>Avviare il programma del robot, o impostare l'obiettivo a mano.</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Avvio</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stato</translation>
    </message>
    <message>
        <source>Static law between stretch angle and stiffness; interpolated uses the points below.</source>
        <translation>Legge statica fra angolo di tensione e rigidezza; interpolated usa i punti seguenti.</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Resta</translation>
    </message>
    <message>
        <source>Steady error</source>
        <translation>Errore a regime</translation>
    </message>
    <message>
        <source>Step response</source>
        <translation>Risposta al gradino</translation>
    </message>
    <message>
        <source>Step response is being computed</source>
        <translation>La risposta al gradino viene calcolata</translation>
    </message>
    <message>
        <source>Steps clipped</source>
        <translation>Passi limitati</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Rigidezza</translation>
    </message>
    <message>
        <source>Stiffness
N/mm</source>
        <translation>Rigidezza
N/mm</translation>
    </message>
    <message>
        <source>Stiffness control</source>
        <translation>Controllo della rigidezza</translation>
    </message>
    <message>
        <source>Stiffness error, RMS: %1 % recorded, %2 % so.</source>
        <translation>Errore di rigidezza, RMS: %1 % registrato, %2 % così.</translation>
    </message>
    <message>
        <source>Stiffness is not observable while its relative uncertainty is above this.</source>
        <translation>La rigidezza non è osservabile finché la sua incertezza relativa è oltre questo valore.</translation>
    </message>
    <message>
        <source>Stiffness is not observable with less force than this.</source>
        <translation>La rigidezza non è osservabile con meno forza di così.</translation>
    </message>
    <message>
        <source>Stiffness is not observable with less indentation than this.</source>
        <translation>La rigidezza non è osservabile con meno indentazione di così.</translation>
    </message>
    <message>
        <source>Stiffness map</source>
        <translation>Mappa di rigidezza</translation>
    </message>
    <message>
        <source>Stiffness measured at each of those angles, rising.</source>
        <translation>Rigidezza misurata a ciascuno di quegli angoli, crescente.</translation>
    </message>
    <message>
        <source>Stiffness minimum force</source>
        <translation>Forza minima</translation>
    </message>
    <message>
        <source>Stiffness minimum indentation</source>
        <translation>Indentazione minima</translation>
    </message>
    <message>
        <source>Stiffness mode</source>
        <translation>Modo di rigidezza</translation>
    </message>
    <message>
        <source>Stiffness pace</source>
        <translation>Ritmo della rigidezza</translation>
    </message>
    <message>
        <source>Stiffness relative sigma limit</source>
        <translation>Limite sigma rigidezza</translation>
    </message>
    <message>
        <source>Stiffness target by hand</source>
        <translation>Rigidezza desiderata impostata a mano</translation>
    </message>
    <message>
        <source>Stiffness target from the robot</source>
        <translation>Rigidezza desiderata dal robot</translation>
    </message>
    <message>
        <source>Stiffness target known</source>
        <translation>Rigidezza desiderata nota</translation>
    </message>
    <message>
        <source>Stiffness target while it is set by hand.</source>
        <translation>Rigidezza desiderata mentre è impostata a mano.</translation>
    </message>
    <message>
        <source>Stiffness the robot tells</source>
        <translation>Rigidezza che il robot dice</translation>
    </message>
    <message>
        <source>Stiffness, N/mm</source>
        <translation>Rigidezza, N/mm</translation>
    </message>
    <message>
        <source>Stiffness, measured and target</source>
        <translation>Rigidezza, misurata e obiettivo</translation>
    </message>
    <message>
        <source>Still missing: %1</source>
        <translation>Manca ancora: %1</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Ferma la registrazione</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Fermo</translation>
    </message>
    <message>
        <source>Stopped by the operator; motors off.</source>
        <translation>Fermato dall'operatore; motori spenti.</translation>
    </message>
    <message>
        <source>Stream (address)</source>
        <translation>Flusso (indirizzo)</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Tensione</translation>
    </message>
    <message>
        <source>Stretch angles of the calibration points, rising.</source>
        <translation>Angoli di tensione dei punti di calibrazione, crescenti.</translation>
    </message>
    <message>
        <source>Stretch at which the resonance was found.</source>
        <translation>Tensione alla quale è stata trovata la risonanza.</translation>
    </message>
    <message>
        <source>Stretch, read by the encoders</source>
        <translation>Tensione, letta dagli encoder</translation>
    </message>
    <message>
        <source>Stretch, °</source>
        <translation>Tensione, °</translation>
    </message>
    <message>
        <source>Subject</source>
        <translation>Soggetto</translation>
    </message>
    <message>
        <source>Subject: expected a code of letters, digits, - and _ such as S07, at most %1 characters; never a name.</source>
        <translation>Soggetto: atteso un codice di lettere, cifre, - e _ come S07, al più %1 caratteri; mai un nome.</translation>
    </message>
    <message>
        <source>Surface level</source>
        <translation>Livello della superficie</translation>
    </message>
    <message>
        <source>Sweeps at two stretches, 10° apart, with an accelerometer.</source>
        <translation>Scansioni a due tensioni, distanti 10°, con un accelerometro.</translation>
    </message>
    <message>
        <source>Tag "%1": expected at most %2 characters.</source>
        <translation>Etichetta "%1": attesi al più %2 caratteri.</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Etichette</translation>
    </message>
    <message>
        <source>Tags of the session</source>
        <translation>Etichette della sessione</translation>
    </message>
    <message>
        <source>Tags, commas between, then Enter</source>
        <translation>Etichette, fra virgole, poi Invio</translation>
    </message>
    <message>
        <source>Tags: %1 are too many; at most %2.</source>
        <translation>Etichette: %1 sono troppe; al più %2.</translation>
    </message>
    <message>
        <source>Take A and B away</source>
        <translation>Togli A e B</translation>
    </message>
    <message>
        <source>Take everything off the cloth, keep your hands away, and take the point: it lasts %1 s.</source>
        <translation>Togli tutto dal tessuto, tieni lontane le mani e prendi il punto: dura %1 s.</translation>
    </message>
    <message>
        <source>Take point</source>
        <translation>Prendi il punto</translation>
    </message>
    <message>
        <source>Take simulated points</source>
        <translation>Prendi punti simulati</translation>
    </message>
    <message>
        <source>Take the cursor, A and B away</source>
        <translation>Togli il cursore, A e B</translation>
    </message>
    <message>
        <source>Take the last point back</source>
        <translation>Togli l'ultimo punto</translation>
    </message>
    <message>
        <source>Take the load off the cover; check the bridge's wiring.</source>
        <translation>Togliere il carico dalla copertura; controllare il cablaggio del ponte.</translation>
    </message>
    <message>
        <source>Take the name %1</source>
        <translation>Prendi il nome %1</translation>
    </message>
    <message>
        <source>Take the present readings as "not touched": distance offsets and load-cell zero. Lift the finger first (Ctrl+T).</source>
        <translation>Prende le letture presenti come "non toccato": offset delle distanze e zero della cella di carico. Alzare prima il dito (Ctrl+T).</translation>
    </message>
    <message>
        <source>Take the tare, or calibrate it again under Calibrate. It does not keep you from arming.</source>
        <translation>Fare la tara, o ripetere la calibrazione in Calibra. Non impedisce di armare.</translation>
    </message>
    <message>
        <source>Take your hands off the cloth and hold the button for %1 s: the duty of each motor grows until it turns.</source>
        <translation>Togli le mani dal tessuto e tieni premuto il pulsante per %1 s: il duty di ogni motore cresce finché gira.</translation>
    </message>
    <message>
        <source>Take your hands off the cloth and hold the button for 16 s: both motors go to their zero at once, then by steps of %1° to %2° and back.</source>
        <translation>Togliere le mani dal tessuto e tenere il pulsante per 16 s: entrambi i motori vanno subito al loro zero, poi a passi di %1° fino a %2° e ritorno.</translation>
    </message>
    <message>
        <source>Takes the last point back.</source>
        <translation>Toglie l'ultimo punto.</translation>
    </message>
    <message>
        <source>Tare</source>
        <translation>Tara</translation>
    </message>
    <message>
        <source>Tare done; the largest offset moved by {:.2f} mm.</source>
        <translation>Tara fatta; l'offset maggiore è cambiato di {:.2f} mm.</translation>
    </message>
    <message>
        <source>Tare failed: {}. Keep the cloth untouched and try again.</source>
        <translation>Tara non riuscita: {}. Non toccare il tessuto e riprovare.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Obiettivo</translation>
    </message>
    <message>
        <source>Target and robot motion</source>
        <translation>Obiettivo e moto del robot</translation>
    </message>
    <message>
        <source>Target by hand</source>
        <translation>Obiettivo a mano</translation>
    </message>
    <message>
        <source>Target from robot</source>
        <translation>Obiettivo dal robot</translation>
    </message>
    <message>
        <source>Test, while held</source>
        <translation>Prova, finché premuto</translation>
    </message>
    <message>
        <source>Text file busy</source>
        <translation>il file è in esecuzione</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Texture</translation>
    </message>
    <message>
        <source>Texture and vibration</source>
        <translation>Texture e vibrazione</translation>
    </message>
    <message>
        <source>Texture signal</source>
        <translation>Segnale della texture</translation>
    </message>
    <message>
        <source>That was the first touch. Esc or STOP switches the motors off; the manual (F1) explains the rest.</source>
        <translation>Questo era il primo tocco. Esc o STOP spegne i motori; il manuale (F1) spiega il resto.</translation>
    </message>
    <message>
        <source>The breakaway of both motors, and sweeps at two stretches, 10° apart, with an accelerometer.</source>
        <translation>Lo spunto di entrambi i motori, e scansioni a due tensioni, distanti 10°, con un accelerometro.</translation>
    </message>
    <message>
        <source>The breakaway of both motors.</source>
        <translation>Lo spunto di entrambi i motori.</translation>
    </message>
    <message>
        <source>The camera sees the cloth mirrored left to right.</source>
        <translation>La telecamera vede il tessuto specchiato da sinistra a destra.</translation>
    </message>
    <message>
        <source>The classic protocol cannot tell.</source>
        <translation>Il protocollo classico non può dirlo.</translation>
    </message>
    <message>
        <source>The clock went back by {:.3f} s; that step moved nothing.</source>
        <translation>L'orologio è tornato indietro di {:.3f} s; quel passo non ha mosso nulla.</translation>
    </message>
    <message>
        <source>The cloth follows the robot's stiffness as it comes.</source>
        <translation>Il tessuto segue la rigidezza del robot come arriva.</translation>
    </message>
    <message>
        <source>The cloth is as stiff as the robot's force over your indentation. A late force shakes.</source>
        <translation>Il tessuto è rigido quanto la forza del robot divisa per l'indentazione del dito. Una forza in ritardo fa tremare.</translation>
    </message>
    <message>
        <source>The cloth measures {:.2f} times as stiff as its law: the law drives alone. Check light, sensors and calibration.</source>
        <translation>Il tessuto misura {:.2f} volte la rigidezza della sua legge: guida solo la legge. Controllare luce, sensori e calibrazione.</translation>
    </message>
    <message>
        <source>The current values (B) are felt.</source>
        <translation>Si sentono i valori attuali (B).</translation>
    </message>
    <message>
        <source>The curves lost %1 samples.</source>
        <translation>Le curve hanno perso %1 campioni.</translation>
    </message>
    <message>
        <source>The damaged profile is kept as %1. The standard values are in force.</source>
        <translation>Il profilo danneggiato resta come %1. Valgono i valori standard.</translation>
    </message>
    <message>
        <source>The devices are asked first. Then the session starts anew; motors stay off until you arm. The choice is remembered.</source>
        <translation>Prima si interrogano i dispositivi. Poi la sessione ricomincia; i motori restano spenti finché non si arma. La scelta viene ricordata.</translation>
    </message>
    <message>
        <source>The devices of last time are not there. Looked for: %1. %2.</source>
        <translation>I dispositivi dell’ultima volta non ci sono. Cercati: %1. %2.</translation>
    </message>
    <message>
        <source>The file before is still being written; try again.</source>
        <translation>Il file precedente è ancora in scrittura; riprovare.</translation>
    </message>
    <message>
        <source>The file begins up to 10 s before you start. Ctrl+M puts a marker.</source>
        <translation>Il file comincia fino a 10 s prima dell'avvio. Ctrl+M mette un marcatore.</translation>
    </message>
    <message>
        <source>The finger never pressed in this session.</source>
        <translation>Il dito non ha mai premuto in questa sessione.</translation>
    </message>
    <message>
        <source>The first encoder counts against its motor's reference (firmware of 2014 and later differ).</source>
        <translation>Il primo encoder conta in senso opposto al riferimento del suo motore (i firmware del 2014 e successivi differiscono).</translation>
    </message>
    <message>
        <source>The fit and its residuals are drawn here.

To begin: %1</source>
        <translation>Qui appaiono la curva e i suoi residui.

Per cominciare: %1</translation>
    </message>
    <message>
        <source>The former session has ended; the new one begins. Motors are off.</source>
        <translation>La sessione precedente è finita; comincia la nuova. I motori sono spenti.</translation>
    </message>
    <message>
        <source>The haptic loop says nothing; the last state was %1.</source>
        <translation>Il ciclo aptico tace; l'ultimo stato era %1.</translation>
    </message>
    <message>
        <source>The language changes when the window is started again.</source>
        <translation>La lingua cambia al prossimo avvio della finestra.</translation>
    </message>
    <message>
        <source>The language stays: the file of the window's settings cannot be written.</source>
        <translation>La lingua resta la stessa: il file delle impostazioni della finestra non può essere scritto.</translation>
    </message>
    <message>
        <source>The last calibration was made by this person.</source>
        <translation>L'ultima calibrazione è stata fatta da questa persona.</translation>
    </message>
    <message>
        <source>The last point is taken back.</source>
        <translation>L'ultimo punto è tolto.</translation>
    </message>
    <message>
        <source>The layout says nothing of the curves: they stay as they are.</source>
        <translation>La disposizione non dice nulla delle curve: restano come sono.</translation>
    </message>
    <message>
        <source>The layout's choice of curves cannot be read: the curves stay as they are.</source>
        <translation>La scelta delle curve della disposizione non si può leggere: le curve restano come sono.</translation>
    </message>
    <message>
        <source>The layout's choice of these curves is not possible and was left out: %1.</source>
        <translation>La scelta della disposizione per queste curve non è possibile ed è stata tralasciata: %1.</translation>
    </message>
    <message>
        <source>The list of sessions (Ctrl+Shift+O)</source>
        <translation>L'elenco delle sessioni (Ctrl+Shift+O)</translation>
    </message>
    <message>
        <source>The model calls this unstable on any touchpad: the stretch would swing on (%1).</source>
        <translation>Il modello lo dice instabile su qualsiasi touchpad: la tensione continuerebbe a oscillare (%1).</translation>
    </message>
    <message>
        <source>The model calls this unstable: the stretch would swing on (%1; the motors' angle is %2 old).</source>
        <translation>Il modello lo dice instabile: la tensione continuerebbe a oscillare (%1; l'angolo dei motori è vecchio di %2).</translation>
    </message>
    <message>
        <source>The motors are off. %1 points so far.</source>
        <translation>I motori sono spenti. %1 punti finora.</translation>
    </message>
    <message>
        <source>The motors are off. The sweep was not finished: its points are left out.</source>
        <translation>I motori sono spenti. La corsa non è stata completata: i suoi punti sono esclusi.</translation>
    </message>
    <message>
        <source>The motors are off: %1. %2 points so far.</source>
        <translation>I motori sono spenti: %1. %2 punti finora.</translation>
    </message>
    <message>
        <source>The motors are on their way.</source>
        <translation>I motori sono in movimento.</translation>
    </message>
    <message>
        <source>The motors have not answered yet: their angle is taken to be 2 ms old, and only what no touchpad bears is asked about.</source>
        <translation>I motori non hanno ancora risposto: il loro angolo si considera vecchio di 2 ms, e si chiede soltanto di ciò che nessun touchpad sopporta.</translation>
    </message>
    <message>
        <source>The motors move as long as this is held, by mouse or space bar, and are off when it is let go.</source>
        <translation>I motori si muovono finché si tiene premuto, col mouse o con la barra spaziatrice, e sono spenti al rilascio.</translation>
    </message>
    <message>
        <source>The motors move; let go and they are off.</source>
        <translation>I motori si muovono; al rilascio si spengono.</translation>
    </message>
    <message>
        <source>The motors' angle is %1 old when it is used.</source>
        <translation>L'angolo dei motori è vecchio di %1 quando viene usato.</translation>
    </message>
    <message>
        <source>The mouse leads to %1</source>
        <translation>Il mouse guida a %1</translation>
    </message>
    <message>
        <source>The other session is drawn %1 s later than recorded.</source>
        <translation>L'altra sessione è disegnata %1 s più tardi di quanto registrata.</translation>
    </message>
    <message>
        <source>The profile could not be set aside as %1: %2.</source>
        <translation>Non è stato possibile mettere da parte il profilo come %1: %2.</translation>
    </message>
    <message>
        <source>The proposal was not taken: %1</source>
        <translation>La proposta non è stata accolta: %1</translation>
    </message>
    <message>
        <source>The recording cannot be replayed exactly: the step gave another result the second time. The measured values are safe. Please report this fault with the file.</source>
        <translation>La registrazione non si può rieseguire esattamente: la seconda volta il passo ha dato un altro risultato. I valori misurati sono al sicuro. Segnalare questo difetto con il file.</translation>
    </message>
    <message>
        <source>The recording did not close as it should. %1. What was written before is safe: Recover in Review makes it whole.</source>
        <translation>La registrazione non si è chiusa come doveva. %1. Ciò che era scritto prima è al sicuro: Recupera, in Revisione, lo rende intero.</translation>
    </message>
    <message>
        <source>The recording loses samples: the computer is too busy. What is written is safe; the gap is marked in the file. Close other programs.</source>
        <translation>La registrazione perde campioni: il computer è troppo occupato. Ciò che è scritto è al sicuro; la lacuna è segnata nel file. Chiudere gli altri programmi.</translation>
    </message>
    <message>
        <source>The recovery was cancelled; %1 is as it was.</source>
        <translation>Il recupero è stato annullato; %1 è rimasto com'era.</translation>
    </message>
    <message>
        <source>The report stands beside the profile.</source>
        <translation>Il rapporto si trova accanto al profilo.</translation>
    </message>
    <message>
        <source>The robot is chosen in the link's panel.</source>
        <translation>Il robot si sceglie nel pannello del collegamento.</translation>
    </message>
    <message>
        <source>The robot must have the same key; "fyd link keygen" makes one.</source>
        <translation>Il robot deve avere la stessa chiave; "fyd link keygen" ne crea una.</translation>
    </message>
    <message>
        <source>The robot's operator asks: {}.</source>
        <translation>L'operatore del robot chiede: {}.</translation>
    </message>
    <message>
        <source>The robot's stiffness is kept here. Under a finger that rests, the cloth only softens; it stiffens when you lift or move on.</source>
        <translation>La rigidezza del robot è tenuta qui. Sotto un dito fermo il tessuto cede soltanto; s'irrigidisce quando il dito si alza o si sposta.</translation>
    </message>
    <message>
        <source>The saved profile cannot be read, so the devices are not opened. %1. Mend the file and start again, or set it aside and go on with the standard values.</source>
        <translation>Il profilo salvato non si può leggere, perciò i dispositivi non vengono aperti. %1. Correggere il file e avviare di nuovo, oppure metterlo da parte e proseguire con i valori standard.</translation>
    </message>
    <message>
        <source>The saved values (A) are felt. Go back to B to change anything.</source>
        <translation>Si sentono i valori salvati (A). Tornare a B per cambiare qualcosa.</translation>
    </message>
    <message>
        <source>The scene cannot be drawn (%1). Haptic point %2, force %3.</source>
        <translation>La scena non può essere disegnata (%1). Punto aptico %2, forza %3.</translation>
    </message>
    <message>
        <source>The scene is being prepared.</source>
        <translation>La scena è in preparazione.</translation>
    </message>
    <message>
        <source>The search was cancelled. Open the session again to look for touches.</source>
        <translation>La ricerca è stata annullata. Riaprire la sessione per cercare i tocchi.</translation>
    </message>
    <message>
        <source>The second encoder counts against its motor's reference.</source>
        <translation>Il secondo encoder conta in senso opposto al riferimento del suo motore.</translation>
    </message>
    <message>
        <source>The selected parameters take their saved values again</source>
        <translation>I parametri scelti riprendono i valori salvati</translation>
    </message>
    <message>
        <source>The session has ended meanwhile</source>
        <translation>La sessione è finita nel frattempo</translation>
    </message>
    <message>
        <source>The session has no devices.</source>
        <translation>La sessione non ha dispositivi.</translation>
    </message>
    <message>
        <source>The session has no devices: it is closed. Choose them beside this, and press Connect.</source>
        <translation>La sessione non ha dispositivi: è chiusa. Sceglierli qui accanto e premere Collega.</translation>
    </message>
    <message>
        <source>The session is closed. %1. Choose other devices.</source>
        <translation>La sessione è chiusa. %1. Scegliere altri dispositivi.</translation>
    </message>
    <message>
        <source>The session is closed: choose devices under Devices.</source>
        <translation>La sessione è chiusa: scegliere i dispositivi in Dispositivi.</translation>
    </message>
    <message>
        <source>The session starts anew; parameters and tare stay. Motors stay off until you arm.</source>
        <translation>La sessione ricomincia; parametri e tara restano. I motori restano spenti finché non si arma.</translation>
    </message>
    <message>
        <source>The simulated finger leaves the cloth…</source>
        <translation>Il dito simulato lascia il tessuto…</translation>
    </message>
    <message>
        <source>The simulated finger plays it: Operate, Finger, Gesture card.</source>
        <translation>Il dito simulato la esegue: Lavoro, Dito, Scheda di gesto.</translation>
    </message>
    <message>
        <source>The standard uncertainty is one standard deviation, from the scatter of the points.</source>
        <translation>L'incertezza tipo è una deviazione standard, dalla dispersione dei punti.</translation>
    </message>
    <message>
        <source>The station did not take the command: too many at once. Try again.</source>
        <translation>La stazione non ha preso il comando: troppi in una volta. Riprovare.</translation>
    </message>
    <message>
        <source>The station did not take the target: too many commands at once. Try again.</source>
        <translation>La stazione non ha preso l'obiettivo: troppi comandi in una volta. Riprovare.</translation>
    </message>
    <message>
        <source>The station is silent: wait until it answers.</source>
        <translation>La stazione tace: attendere che risponda.</translation>
    </message>
    <message>
        <source>The step refused %1: it cannot be used now.</source>
        <translation>Il passo ha rifiutato %1: ora non può essere usato.</translation>
    </message>
    <message>
        <source>The target from above. Below, how far each mark is off. Crosses: points the others contradict.</source>
        <translation>Il bersaglio visto dall'alto. Sotto, quanto è fuori ciascun segno. Croci: punti che gli altri contraddicono.</translation>
    </message>
    <message>
        <source>The target is out of reach; rendering the nearest, {:.3f} N/mm.</source>
        <translation>L'obiettivo è fuori portata; si rende il più vicino, {:.3f} N/mm.</translation>
    </message>
    <message>
        <source>The theme changes once the motors are off: Esc would not be heard meanwhile.</source>
        <translation>Il tema cambia quando i motori sono spenti: nel frattempo Esc non sarebbe sentito.</translation>
    </message>
    <message>
        <source>The touchpad answers. Calibrate its parts, so that what it shows can be trusted; motors move only while you hold a button.</source>
        <translation>Il touchpad risponde. Calibrarne le parti, perché ci si possa fidare di ciò che mostra; i motori si muovono solo mentre si tiene premuto un pulsante.</translation>
    </message>
    <message>
        <source>The touchpad is not simulated: take its points by measuring.</source>
        <translation>Il touchpad non è simulato: prendere i suoi punti misurando.</translation>
    </message>
    <message>
        <source>The touchpad's own</source>
        <translation>Del touchpad stesso</translation>
    </message>
    <message>
        <source>The values are, within the tolerance stated for that.</source>
        <translation>I valori lo sono, entro la tolleranza indicata per questo.</translation>
    </message>
    <message>
        <source>The whole recording</source>
        <translation>Tutta la registrazione</translation>
    </message>
    <message>
        <source>The whole session</source>
        <translation>Tutta la sessione</translation>
    </message>
    <message>
        <source>Theme of the system</source>
        <translation>Tema del sistema</translation>
    </message>
    <message>
        <source>Then hold Re-arm.</source>
        <translation>Poi tenere premuto Riarma.</translation>
    </message>
    <message>
        <source>There are no values to save yet.</source>
        <translation>Non ci sono ancora valori da salvare.</translation>
    </message>
    <message>
        <source>There are no values yet to go to.</source>
        <translation>Non ci sono ancora valori a cui andare.</translation>
    </message>
    <message>
        <source>There is no parameter '%1'.</source>
        <translation>Non c'è il parametro '%1'.</translation>
    </message>
    <message>
        <source>There is nothing to accept yet: %1.</source>
        <translation>Non c'è ancora nulla da accettare: %1.</translation>
    </message>
    <message>
        <source>These points are measured: discard them before you take simulated ones.</source>
        <translation>Questi punti sono misurati: scartarli prima di prenderne di simulati.</translation>
    </message>
    <message>
        <source>These points are simulated: discard them before you measure.</source>
        <translation>Questi punti sono simulati: scartarli prima di misurare.</translation>
    </message>
    <message>
        <source>These points were measured on another touchpad: discard them before you measure on the simulated one.</source>
        <translation>Questi punti sono stati misurati su un altro touchpad: scartarli prima di misurare su quello simulato.</translation>
    </message>
    <message>
        <source>These points were measured on the simulated touchpad: discard them before you measure on this one.</source>
        <translation>Questi punti sono stati misurati sul touchpad simulato: scartarli prima di misurare su questo.</translation>
    </message>
    <message>
        <source>Thesis kd</source>
        <translation>Kd della tesi</translation>
    </message>
    <message>
        <source>Thesis ki</source>
        <translation>Ki della tesi</translation>
    </message>
    <message>
        <source>Thesis kp</source>
        <translation>Kp della tesi</translation>
    </message>
    <message>
        <source>Thesis mode: grey values below it are the finger.</source>
        <translation>Modo thesis: i valori di grigio al di sotto sono il dito.</translation>
    </message>
    <message>
        <source>Thesis mode: smallest dark area that counts as a touch, in pixels of its 160 × 120 picture.</source>
        <translation>Modo thesis: minima area scura che conta come tocco, in pixel della sua immagine di 160 × 120.</translation>
    </message>
    <message>
        <source>Thesis mode: the robot goes where the finger is, with a jump at each new touch; off: each touch moves it from where it stands.</source>
        <translation>Modo tesi: il robot va dove è il dito, con un salto a ogni nuovo tocco; spento: ogni tocco lo muove da dove si trova.</translation>
    </message>
    <message>
        <source>They are asked again by themselves: check power and cables.</source>
        <translation>Vengono interrogati di nuovo da soli: controllare alimentazione e cavi.</translation>
    </message>
    <message>
        <source>They are asked again by themselves: close the other program.</source>
        <translation>Vengono interrogati di nuovo da soli: chiudere l'altro programma.</translation>
    </message>
    <message>
        <source>This angle is taken.</source>
        <translation>Questo angolo è preso.</translation>
    </message>
    <message>
        <source>This computer opens no folder from here: %1.</source>
        <translation>Questo computer non apre cartelle da qui: %1.</translation>
    </message>
    <message>
        <source>This computer opens no folder from here: %1. Copy path takes the file's path along.</source>
        <translation>Questo computer non apre cartelle da qui: %1. Copia il percorso prende con sé quello del file.</translation>
    </message>
    <message>
        <source>This computer's own address, HOST:PORT. The robot calls there; 0.0.0.0 hears every network.</source>
        <translation>L'indirizzo di questo computer, HOST:PORT. Il robot chiama lì; 0.0.0.0 ascolta ogni rete.</translation>
    </message>
    <message>
        <source>This depth is taken: press deeper or less deep, then let go and go on to the next stretch.</source>
        <translation>Questa profondità è presa: premere di più o di meno, poi rilasciare e passare alla tensione seguente.</translation>
    </message>
    <message>
        <source>This part's points are taken by themselves while the button is held.</source>
        <translation>I punti di questa parte vengono presi da soli mentre si tiene il pulsante.</translation>
    </message>
    <message>
        <source>This robot tells no force: its stiffness is taken instead.</source>
        <translation>Questo robot non dice la forza: si prende la sua rigidezza.</translation>
    </message>
    <message>
        <source>This session's</source>
        <translation>Di questa sessione</translation>
    </message>
    <message>
        <source>This source has none</source>
        <translation>Questa sorgente non ne ha</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Time constant of the derivative's low-pass.</source>
        <translation>Costante di tempo del passa-basso del termine derivativo.</translation>
    </message>
    <message>
        <source>Time in which a motor reaches 63 % of its speed.</source>
        <translation>Tempo in cui un motore raggiunge il 63 % della sua velocità.</translation>
    </message>
    <message>
        <source>Time over which a new method, filter or gain takes over.</source>
        <translation>Tempo nel quale un nuovo metodo, filtro o guadagno subentra.</translation>
    </message>
    <message>
        <source>Time over which the measured stiffness' noise repeats itself; auto-tune measures it.</source>
        <translation>Tempo dopo il quale il rumore della rigidezza misurata si ripete; la regolazione automatica lo misura.</translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation>Tempo mostrato</translation>
    </message>
    <message>
        <source>Time shown in seconds</source>
        <translation>Tempo mostrato in secondi</translation>
    </message>
    <message>
        <source>Times lost</source>
        <translation>Volte perso</translation>
    </message>
    <message>
        <source>Tint what the detector takes for the finger (M)</source>
        <translation>Colora ciò che il rilevatore prende per il dito (M)</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>troppi livelli di collegamenti simbolici</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>troppi file aperti</translation>
    </message>
    <message>
        <source>Too many open files in system</source>
        <translation>troppi file aperti nel sistema</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Alto</translation>
    </message>
    <message>
        <source>Top edge of the cloth in the camera's picture.</source>
        <translation>Bordo superiore del tessuto nell'immagine della telecamera.</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Tocca</translation>
    </message>
    <message>
        <source>Touch %1 at %2: peak force %3, peak indentation %4, stiffness %5 of %6 asked, settled after %7</source>
        <translation>Tocco %1 a %2: forza di picco %3, indentazione di picco %4, rigidezza %5 su %6 richiesti, assestato dopo %7</translation>
    </message>
    <message>
        <source>Touches</source>
        <translation>Tocchi</translation>
    </message>
    <message>
        <source>Touchpad</source>
        <translation>Touchpad</translation>
    </message>
    <message>
        <source>Translation</source>
        <translation>Traslazione</translation>
    </message>
    <message>
        <source>Trial %1 of %2: %3.</source>
        <translation>Prova %1 di %2: %3.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Riprova</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>Regola</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Regolazione</translation>
    </message>
    <message>
        <source>Tuning panel</source>
        <translation>Pannello di regolazione</translation>
    </message>
    <message>
        <source>Turn from the picture's axes to the touchpad's, counter-clockwise seen from above.</source>
        <translation>Rotazione dagli assi dell'immagine a quelli del touchpad, antioraria vista dall'alto.</translation>
    </message>
    <message>
        <source>Two presses over each distance sensor, one at least %1 times as deep as the other.</source>
        <translation>Due pressioni sopra ogni sensore di distanza, una profonda almeno %1 volte l'altra.</translation>
    </message>
    <message>
        <source>Type a few letters of a command</source>
        <translation>Scrivere alcune lettere di un comando</translation>
    </message>
    <message>
        <source>Type a stretch and hold the button: the motors go there. Meanwhile press the cloth to three depths, each for a second; points are taken by themselves.</source>
        <translation>Scrivere una tensione e tenere il pulsante: i motori vanno lì. Intanto premere il tessuto a tre profondità, un secondo ciascuna; i punti si prendono da soli.</translation>
    </message>
    <message>
        <source>UDP {}: {}: {}</source>
        <translation>UDP {}: {}: {}</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Incertezza</translation>
    </message>
    <message>
        <source>Uncertainty of the cloth's formula</source>
        <translation>Incertezza della formula del tessuto</translation>
    </message>
    <message>
        <source>Uncertainty of the contact radius share</source>
        <translation>Incertezza della quota del raggio di contatto</translation>
    </message>
    <message>
        <source>Uncertainty of the tension ratio</source>
        <translation>Incertezza del rapporto di tensione</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Undo %1 (Ctrl+Z)</source>
        <translation>Annulla %1 (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Unit of: %1</source>
        <translation>Unità di: %1</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Sconosciuto</translation>
    </message>
    <message>
        <source>Upper end of %1</source>
        <translation>Estremo superiore di %1</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Usa</translation>
    </message>
    <message>
        <source>Use %1 as: %2</source>
        <translation>Usa %1 come: %2</translation>
    </message>
    <message>
        <source>Use a preset's values</source>
        <translation>Usa i valori di una preimpostazione</translation>
    </message>
    <message>
        <source>Use the chosen preset's values; one step to undo (Enter on the list)</source>
        <translation>Usa i valori della preimpostazione scelta; un solo passo da annullare (Invio sulla lista)</translation>
    </message>
    <message>
        <source>Use the new value all the same; undo takes it back</source>
        <translation>Usa lo stesso il nuovo valore; Annulla torna al precedente</translation>
    </message>
    <message>
        <source>Use the proposed values; one step to undo</source>
        <translation>Usa i valori proposti; un solo passo da annullare</translation>
    </message>
    <message>
        <source>Use the simulation</source>
        <translation>Usare la simulazione</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valore</translation>
    </message>
    <message>
        <source>Values in force and new values</source>
        <translation>Valori in vigore e nuovi valori</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdetto</translation>
    </message>
    <message>
        <source>Vibration</source>
        <translation>Vibrazione</translation>
    </message>
    <message>
        <source>Vibration at the finger, reckoned (%1)</source>
        <translation>Vibrazione al dito, calcolata (%1)</translation>
    </message>
    <message>
        <source>Vibration duty, held by the motor board</source>
        <translation>Duty della vibrazione, tenuto dalla scheda motori</translation>
    </message>
    <message>
        <source>Vibration: motors and cloth</source>
        <translation>Vibrazione: motori e tessuto</translation>
    </message>
    <message>
        <source>Video file</source>
        <translation>File video</translation>
    </message>
    <message>
        <source>Video without loss</source>
        <translation>Video senza perdite</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Wait until it answers; close other programs on this machine.</source>
        <translation>Attendere che risponda; chiudere gli altri programmi su questo computer.</translation>
    </message>
    <message>
        <source>Waiting for a robot</source>
        <translation>In attesa di un robot</translation>
    </message>
    <message>
        <source>Waiting for the disk …</source>
        <translation>In attesa del disco …</translation>
    </message>
    <message>
        <source>Waiting for the haptic loop.</source>
        <translation>In attesa del ciclo aptico.</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avvertenza</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Peso</translation>
    </message>
    <message>
        <source>Welcome. Try everything on the simulated touchpad, or connect your own. The answer is remembered and can be changed in Devices.</source>
        <translation>Benvenuti. Si può provare tutto sul touchpad simulato, o collegare il proprio. La risposta viene ricordata e si può cambiare in Dispositivi.</translation>
    </message>
    <message>
        <source>Well</source>
        <translation>Bene</translation>
    </message>
    <message>
        <source>What differs from the saved profile</source>
        <translation>Che cosa differisce dal profilo salvato</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Che cosa è successo</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>E se</translation>
    </message>
    <message>
        <source>What one is used as goes into the form; Connect takes it.</source>
        <translation>I pulsanti mettono il dispositivo nel modulo; Collega lo prende.</translation>
    </message>
    <message>
        <source>What stands in the robot's place and is touched; "fyd scene keys" shows what it may say.</source>
        <translation>Ciò che sta al posto del robot e viene toccato; "fyd scene keys" mostra che cosa può dire.</translation>
    </message>
    <message>
        <source>What the cloth is identified from</source>
        <translation>Da che cosa si identifica il tessuto</translation>
    </message>
    <message>
        <source>What to do now</source>
        <translation>Che cosa fare ora</translation>
    </message>
    <message>
        <source>What was asked, and what the part that holds it says of it. A value counts as confirmed only when that part has said so.</source>
        <translation>Che cosa è stato chiesto, e che cosa ne dice la parte che lo tiene. Un valore è confermato solo quando quella parte lo ha detto.</translation>
    </message>
    <message>
        <source>What was fitted, with its standard uncertainty</source>
        <translation>Ciò che è stato adattato, con la sua incertezza tipo</translation>
    </message>
    <message>
        <source>Where the arm is led: where the finger will be when it gets there.</source>
        <translation>Dove è portato il braccio: dove sarà il dito quando il braccio vi arriva.</translation>
    </message>
    <message>
        <source>Where the finger was said to be, against where it was seen after: RMS over about a second.</source>
        <translation>Dove si diceva che fosse il dito, rispetto a dove è stato visto dopo: RMS su circa un secondo.</translation>
    </message>
    <message>
        <source>Where the newest touch leads the arm by itself: x, y, z.</source>
        <translation>Dove il tocco più recente porta il braccio da solo: x, y, z.</translation>
    </message>
    <message>
        <source>Whether the way to the finger was identified; the constants below are guesses otherwise.</source>
        <translation>Se la via fino al dito è stata identificata; altrimenti le costanti qui sotto sono supposizioni.</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Chi</translation>
    </message>
    <message>
        <source>Who measured</source>
        <translation>Chi ha misurato</translation>
    </message>
    <message>
        <source>Who measured? Write your name at the right, then accept.</source>
        <translation>Chi ha misurato? Scrivere il nome a destra, poi accettare.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Larghezza</translation>
    </message>
    <message>
        <source>Width of the cloth in the camera's picture.</source>
        <translation>Larghezza del tessuto nell'immagine della telecamera.</translation>
    </message>
    <message>
        <source>Words of the name, the identifier, the help or the group (Ctrl+F); Enter goes to the first that is found</source>
        <translation>Parole del nome, dell'identificatore, dell'aiuto o del gruppo (Ctrl+F); Invio porta al primo trovato</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Scrivi</translation>
    </message>
    <message>
        <source>Write a note at the cursor</source>
        <translation>Scrivi una nota al cursore</translation>
    </message>
    <message>
        <source>Writes the new values with their record, and begins the session anew with them.</source>
        <translation>Scrive i nuovi valori con il loro verbale, e ricomincia la sessione con essi.</translation>
    </message>
    <message>
        <source>Writes this part's last calibration, before and after, as a PDF beside the profile.</source>
        <translation>Scrive l'ultima calibrazione di questa parte, prima e dopo, in un PDF accanto al profilo.</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Scrittura di %1</translation>
    </message>
    <message>
        <source>a code, such as S07; never a name</source>
        <translation>un codice, come S07; mai un nome</translation>
    </message>
    <message>
        <source>a condition without a name</source>
        <translation>una condizione senza nome</translation>
    </message>
    <message>
        <source>a cycle</source>
        <translation>un ciclo</translation>
    </message>
    <message>
        <source>a folder has none</source>
        <translation>una cartella non ne ha</translation>
    </message>
    <message>
        <source>a key that no record has</source>
        <translation>una chiave che nessuna voce ha</translation>
    </message>
    <message>
        <source>a line for each axis</source>
        <translation>una retta per ogni asse</translation>
    </message>
    <message>
        <source>a line for each encoder</source>
        <translation>una retta per ogni encoder</translation>
    </message>
    <message>
        <source>a line of at most {} bytes</source>
        <translation>una riga di al più {} byte</translation>
    </message>
    <message>
        <source>a list of numbers, each from {} to {}{}</source>
        <translation>una lista di numeri, ciascuno da {} a {}{}</translation>
    </message>
    <message>
        <source>a motor stands beyond control.motor_limit_deg: check the encoder's zero</source>
        <translation>un motore sta oltre control.motor_limit_deg: controllare lo zero dell'encoder</translation>
    </message>
    <message>
        <source>a number from {} to {}{}</source>
        <translation>un numero da {} a {}{}</translation>
    </message>
    <message>
        <source>a number with a point, or nan</source>
        <translation>un numero con il punto, o nan</translation>
    </message>
    <message>
        <source>a parameter</source>
        <translation>un parametro</translation>
    </message>
    <message>
        <source>a picture is {} × {} px, those before {} × {}; choose a time with one size</source>
        <translation>un'immagine è di {} × {} px, le precedenti di {} × {}; scegliere un tempo con una sola dimensione</translation>
    </message>
    <message>
        <source>a picture of {} x {} pixels: too large</source>
        <translation>un'immagine di {} x {} pixel: troppo grande</translation>
    </message>
    <message>
        <source>a polygon has vertex {}; expected one of the {} of this {} file</source>
        <translation>un poligono ha il vertice {}; atteso uno dei {} di questo file {}</translation>
    </message>
    <message>
        <source>a prediction of {} ms at most: expected 0 to 1000</source>
        <translation>una predizione di al più {} ms: atteso da 0 a 1000</translation>
    </message>
    <message>
        <source>a reason that this program does not know</source>
        <translation>un motivo che questo programma non conosce</translation>
    </message>
    <message>
        <source>a recording</source>
        <translation>una registrazione</translation>
    </message>
    <message>
        <source>a recording is being written</source>
        <translation>una registrazione è in corso</translation>
    </message>
    <message>
        <source>a recording of format {}; this program reads format {}</source>
        <translation>una registrazione in formato {}; questo programma legge il formato {}</translation>
    </message>
    <message>
        <source>a scene of format {}; this program reads format {}</source>
        <translation>una scena di formato {}; questo programma legge il formato {}</translation>
    </message>
    <message>
        <source>a scene of {} bodies with the contacts of {}</source>
        <translation>una scena di {} corpi con i contatti di {}</translation>
    </message>
    <message>
        <source>a second</source>
        <translation>al secondo</translation>
    </message>
    <message>
        <source>a second robot</source>
        <translation>un secondo robot</translation>
    </message>
    <message>
        <source>a sensor is outside its span</source>
        <translation>un sensore è fuori dal suo campo</translation>
    </message>
    <message>
        <source>a state of a program before revision a4d2b6a</source>
        <translation>lo stato di un programma anteriore alla revisione a4d2b6a</translation>
    </message>
    <message>
        <source>a stream has none</source>
        <translation>un flusso non ne ha</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un testo</translation>
    </message>
    <message>
        <source>a touchpad that is not known</source>
        <translation>un touchpad non noto</translation>
    </message>
    <message>
        <source>a turning motor has %1 % of its breakaway</source>
        <translation>un motore che gira ha il %1 % del suo spunto</translation>
    </message>
    <message>
        <source>a value is not finite</source>
        <translation>un valore non è finito</translation>
    </message>
    <message>
        <source>a video file has none</source>
        <translation>un file video non ne ha</translation>
    </message>
    <message>
        <source>a weight is negative</source>
        <translation>un peso è negativo</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un numero intero</translation>
    </message>
    <message>
        <source>a whole number from {} to {}{}</source>
        <translation>un numero intero da {} a {}{}</translation>
    </message>
    <message>
        <source>a wrong tare of %1 ± %2 is taken into account</source>
        <translation>si tiene conto di una tara errata di %1 ± %2</translation>
    </message>
    <message>
        <source>aborted</source>
        <translation>interrotta</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>accelerazione</translation>
    </message>
    <message>
        <source>acceleration limit {} mm/s²: expected 10 to 100000</source>
        <translation>limite di accelerazione {} mm/s²: atteso da 10 a 100000</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>accettata</translation>
    </message>
    <message>
        <source>adaptive follows uneven and changing light; thesis is the printed algorithm.</source>
        <translation>adaptive segue una luce irregolare e variabile; thesis è l'algoritmo stampato.</translation>
    </message>
    <message>
        <source>adc rises from {:.0f} at {:g} mm to {:.0f} at {:g} mm, but a farther target must read less: measure both again</source>
        <translation>adc sale da {:.0f} a {:g} mm fino a {:.0f} a {:g} mm, ma un bersaglio più lontano deve leggere meno: misurare di nuovo entrambi</translation>
    </message>
    <message>
        <source>adc rises from {:.0f} at {:g} mm to {:.0f} at {:g} mm, but a farther target must read less: measure both again, and leave out distances the sensor is too near for</source>
        <translation>adc sale da {:.0f} a {:g} mm fino a {:.0f} a {:g} mm, ma un bersaglio più lontano deve leggere meno: misurare di nuovo entrambi, e tralasciare le distanze troppo vicine per il sensore</translation>
    </message>
    <message>
        <source>add weights between {:.3g} and {:.3g} N</source>
        <translation>aggiungere pesi tra {:.3g} e {:.3g} N</translation>
    </message>
    <message>
        <source>address "{}": "{}" is not an {} address (names other than localhost are not looked up)</source>
        <translation>indirizzo "{}": "{}" non è un indirizzo {} (i nomi diversi da localhost non si cercano)</translation>
    </message>
    <message>
        <source>address "{}": an IPv6 address stands in brackets, such as [::1]:3490</source>
        <translation>indirizzo "{}": un indirizzo IPv6 sta fra parentesi quadre, come [::1]:3490</translation>
    </message>
    <message>
        <source>address "{}": no port; expected HOST:PORT such as 127.0.0.1:3490 or [::1]:3490</source>
        <translation>indirizzo "{}": manca la porta; atteso HOST:PORT come 127.0.0.1:3490 o [::1]:3490</translation>
    </message>
    <message>
        <source>address "{}": only a link-local address (fe80::…) has an interface after %</source>
        <translation>indirizzo "{}": solo un indirizzo link-local (fe80::…) ha un'interfaccia dopo %</translation>
    </message>
    <message>
        <source>address "{}": port "{}" is not a whole number from 0 to 65535</source>
        <translation>indirizzo "{}": la porta "{}" non è un numero intero da 0 a 65535</translation>
    </message>
    <message>
        <source>address "{}": there is no network interface "{}"</source>
        <translation>indirizzo "{}": non c'è un'interfaccia di rete "{}"</translation>
    </message>
    <message>
        <source>again and again</source>
        <translation>di continuo</translation>
    </message>
    <message>
        <source>ageing: %1</source>
        <translation>invecchia: %1</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>allarme</translation>
    </message>
    <message>
        <source>all back to the saved values</source>
        <translation>tutto ai valori salvati</translation>
    </message>
    <message>
        <source>all four edges are held</source>
        <translation>tutti e quattro i bordi sono tenuti</translation>
    </message>
    <message>
        <source>all parts</source>
        <translation>tutte le parti</translation>
    </message>
    <message>
        <source>all points at {} V</source>
        <translation>tutti i punti a {} V</translation>
    </message>
    <message>
        <source>all presses are about equally deep, so a wrong tare cannot be told from stiffness: press to different depths</source>
        <translation>tutte le pressioni hanno circa la stessa profondità, quindi una tara errata non si distingue dalla rigidezza: premere a profondità diverse</translation>
    </message>
    <message>
        <source>an HDF5 file, but not a recording of the console</source>
        <translation>un file HDF5, ma non una registrazione della console</translation>
    </message>
    <message>
        <source>an HDF5 file, but not a recording of the console, or its first bytes are damaged</source>
        <translation>un file HDF5, ma non una registrazione della console, o i suoi primi byte sono danneggiati</translation>
    </message>
    <message>
        <source>an answer of another unit</source>
        <translation>una risposta di un'altra unità</translation>
    </message>
    <message>
        <source>an answer that does not fit the question</source>
        <translation>una risposta che non corrisponde alla domanda</translation>
    </message>
    <message>
        <source>an answer with a wrong checksum; is the speed right and the line terminated?</source>
        <translation>una risposta con somma di controllo errata; la velocità è giusta e la linea terminata?</translation>
    </message>
    <message>
        <source>an axis spreads by {:.3f} g; expected at most {:g}: it moves: put the robot to rest</source>
        <translation>un asse oscilla di {:.3f} g; atteso al più {:g}: si muove: mettere il robot a riposo</translation>
    </message>
    <message>
        <source>an exception with a number that Modbus does not have</source>
        <translation>un'eccezione con un numero che Modbus non prevede</translation>
    </message>
    <message>
        <source>an unknown state</source>
        <translation>uno stato sconosciuto</translation>
    </message>
    <message>
        <source>an unknown that no point tells anything of</source>
        <translation>un'incognita di cui nessun punto dice nulla</translation>
    </message>
    <message>
        <source>and {} more</source>
        <translation>e altri {}</translation>
    </message>
    <message>
        <source>angles, indentations and forces differ in number</source>
        <translation>angoli, indentazioni e forze sono in numero diverso</translation>
    </message>
    <message>
        <source>another console</source>
        <translation>un'altra console</translation>
    </message>
    <message>
        <source>another console, process %1 on %2</source>
        <translation>un'altra console, processo %1 su %2</translation>
    </message>
    <message>
        <source>another file</source>
        <translation>un altro file</translation>
    </message>
    <message>
        <source>another program has made the file shorter while it was written</source>
        <translation>un altro programma ha accorciato il file mentre veniva scritto</translation>
    </message>
    <message>
        <source>another robot is served</source>
        <translation>un altro robot è servito</translation>
    </message>
    <message>
        <source>answers missing</source>
        <translation>risposte mancanti</translation>
    </message>
    <message>
        <source>any text of the header may be wrong: {}</source>
        <translation>ogni testo dell'intestazione può essere errato: {}</translation>
    </message>
    <message>
        <source>area</source>
        <translation>area</translation>
    </message>
    <message>
        <source>arithmetic {}: expected 1 or more</source>
        <translation>aritmetica {}: atteso 1 o più</translation>
    </message>
    <message>
        <source>asked for {:.0f} %, the camera took {:.0f} %</source>
        <translation>chiesto {:.0f} %, la telecamera ha preso {:.0f} %</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>a %1</translation>
    </message>
    <message>
        <source>at %1: %2, damping %3, %4 % left</source>
        <translation>a %1: %2, smorzamento %3, resta il %4 %</translation>
    </message>
    <message>
        <source>at edge</source>
        <translation>al bordo</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>a riposo</translation>
    </message>
    <message>
        <source>at rest it measures {:.3f} g; expected 1 within {:g}: check the counts per g of the sensor</source>
        <translation>a riposo misura {:.3f} g; atteso 1 entro {:g}: controllare i conteggi per g del sensore</translation>
    </message>
    <message>
        <source>at rest {:.4f} g, spread {:.4f} g</source>
        <translation>a riposo {:.4f} g, dispersione {:.4f} g</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>auto-tune</source>
        <translation>regolazione automatica</translation>
    </message>
    <message>
        <source>auto-tune: cancelled</source>
        <translation>regolazione automatica: annullata</translation>
    </message>
    <message>
        <source>auto-tune: no time constant up to {} s keeps gain margin {} and phase margin {}° (dead time {:.3f} s, lag {:.3f} s, noise {:.1f} %)</source>
        <translation>regolazione automatica: nessuna costante di tempo fino a {} s conserva il margine di guadagno {} e il margine di fase {}° (tempo morto {:.3f} s, ritardo {:.3f} s, rumore {:.1f} %)</translation>
    </message>
    <message>
        <source>average more readings at each distance, target square to the sensor</source>
        <translation>fare la media di più letture a ogni distanza, bersaglio perpendicolare al sensore</translation>
    </message>
    <message>
        <source>axes "{}": expected x, y and z once each, such as -y,-x,z</source>
        <translation>assi "{}": attesi x, y e z una volta ciascuno, come -y,-x,z</translation>
    </message>
    <message>
        <source>back to the saved values</source>
        <translation>ritorno ai valori salvati</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>cattiva</translation>
    </message>
    <message>
        <source>before a handshake</source>
        <translation>prima di un saluto</translation>
    </message>
    <message>
        <source>being recorded</source>
        <translation>in registrazione</translation>
    </message>
    <message>
        <source>being written: %1</source>
        <translation>in scrittura: %1</translation>
    </message>
    <message>
        <source>black picture</source>
        <translation>immagine nera</translation>
    </message>
    <message>
        <source>blurred</source>
        <translation>sfocato</translation>
    </message>
    <message>
        <source>bookmark</source>
        <translation>segnalibro</translation>
    </message>
    <message>
        <source>border of a soft body is {}; expected between 0 and 1</source>
        <translation>border di un corpo morbido è {}; atteso fra 0 e 1</translation>
    </message>
    <message>
        <source>both ends hold the same scene</source>
        <translation>entrambe le estremità hanno la stessa scena</translation>
    </message>
    <message>
        <source>breakaway</source>
        <translation>spunto</translation>
    </message>
    <message>
        <source>breakaway of each motor; resonance of the cloth under a finger</source>
        <translation>spunto di ogni motore; risonanza del tessuto sotto un dito</translation>
    </message>
    <message>
        <source>brightness</source>
        <translation>luminosità</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>di %1</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>a mano</translation>
    </message>
    <message>
        <source>calibrated on {}, and this is {}: the defaults are used instead ({})</source>
        <translation>calibrato su: {}; questo è: {}. Si usano invece i valori predefiniti ({})</translation>
    </message>
    <message>
        <source>calibrated {} days ago: repeat it</source>
        <translation>calibrato {} giorni fa: ripetere</translation>
    </message>
    <message>
        <source>calibrated {} days ago: repeat it soon</source>
        <translation>calibrato {} giorni fa: ripetere presto</translation>
    </message>
    <message>
        <source>calibrated {} days in the future: the computer's clock was or is wrong</source>
        <translation>calibrato {} giorni nel futuro: l'orologio del computer era o è sbagliato</translation>
    </message>
    <message>
        <source>calibration points not accepted: %1</source>
        <translation>punti di calibrazione non accettati: %1</translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>telecamera %1</translation>
    </message>
    <message>
        <source>camera '{}': no such file or folder; expected a device number, a path such as /dev/video0, id=SERIAL, a video file, a folder of pictures or a stream's URL</source>
        <translation>telecamera '{}': nessun file o cartella con questo nome; atteso un numero di dispositivo, un percorso come /dev/video0, id=SERIAL, un file video, una cartella di immagini o l'URL di un flusso</translation>
    </message>
    <message>
        <source>camera device</source>
        <translation>telecamera (dispositivo)</translation>
    </message>
    <message>
        <source>camera device '{}'</source>
        <translation>telecamera '{}'</translation>
    </message>
    <message>
        <source>camera device '{}': there is none; capture devices found: {}</source>
        <translation>telecamera '{}': non esiste; dispositivi di acquisizione trovati: {}</translation>
    </message>
    <message>
        <source>camera device {}: there is no {}; capture devices found: {}</source>
        <translation>telecamera {}: non c'è {}; dispositivi di acquisizione trovati: {}</translation>
    </message>
    <message>
        <source>camera folder '{}': no pictures; expected {}</source>
        <translation>cartella della telecamera '{}': nessuna immagine; attese {}</translation>
    </message>
    <message>
        <source>camera folder '{}': {}</source>
        <translation>cartella della telecamera '{}': {}</translation>
    </message>
    <message>
        <source>camera folder: {}</source>
        <translation>cartella della telecamera: {}</translation>
    </message>
    <message>
        <source>camera stream '{}'</source>
        <translation>flusso della telecamera '{}'</translation>
    </message>
    <message>
        <source>camera: none given; only the simulated touchpad has a simulated camera</source>
        <translation>telecamera: nessuna indicata; solo il touchpad simulato ha una telecamera simulata</translation>
    </message>
    <message>
        <source>camera: {}</source>
        <translation>telecamera: {}</translation>
    </message>
    <message>
        <source>cancelled before it was done</source>
        <translation>annullato prima della fine</translation>
    </message>
    <message>
        <source>cannot be judged on held-out distances</source>
        <translation>non può essere giudicata su distanze tenute da parte</translation>
    </message>
    <message>
        <source>cannot be read back</source>
        <translation>non si può rileggere</translation>
    </message>
    <message>
        <source>cannot be set to non-blocking</source>
        <translation>non può essere reso non bloccante</translation>
    </message>
    <message>
        <source>cannot listen</source>
        <translation>ascolto impossibile</translation>
    </message>
    <message>
        <source>cannot listen, another program holds the port</source>
        <translation>ascolto impossibile, un altro programma occupa la porta</translation>
    </message>
    <message>
        <source>cannot open a socket</source>
        <translation>non può aprire un socket</translation>
    </message>
    <message>
        <source>cannot tell its own address</source>
        <translation>non può dire il proprio indirizzo</translation>
    </message>
    <message>
        <source>catalogue 'sqlite:{}': expected a file</source>
        <translation>catalogo 'sqlite:{}': atteso un file</translation>
    </message>
    <message>
        <source>catalogue '{}': a path with a quotation mark is not possible</source>
        <translation>catalogo '{}': un percorso con virgolette non è possibile</translation>
    </message>
    <message>
        <source>catalogue '{}': expected sqlite:PATH, postgresql:host=… dbname=… user=…, or none</source>
        <translation>catalogo '{}': atteso sqlite:PATH, postgresql:host=… dbname=… user=…, o none</translation>
    </message>
    <message>
        <source>catalogue '{}://…': expected sqlite:PATH, postgresql:host=… dbname=… user=…, or none</source>
        <translation>catalogo '{}://…': atteso sqlite:PERCORSO, postgresql:host=… dbname=… user=…, o none</translation>
    </message>
    <message>
        <source>catalogue: libpq cannot read the words after '{}'; expected host=… dbname=… user=…</source>
        <translation>catalogo: libpq non può leggere le parole dopo '{}'; atteso host=… dbname=… user=…</translation>
    </message>
    <message>
        <source>catalogue: the word carries a password, which logs and lists of processes would show; put it into ~/.pgpass (mode 600) instead</source>
        <translation>catalogo: la parola contiene una password, che registri ed elenchi di processi mostrerebbero; metterla invece in ~/.pgpass (modo 600)</translation>
    </message>
    <message>
        <source>changed and not saved: %1</source>
        <translation>modificati e non salvati: %1</translation>
    </message>
    <message>
        <source>changed and not saved: %1 and %2 more</source>
        <translation>modificati e non salvati: %1 e altri %2</translation>
    </message>
    <message>
        <source>changed since it was calibrated %1 days ago</source>
        <translation>cambiato dopo la calibrazione di %1 giorni fa</translation>
    </message>
    <message>
        <source>changed since it was calibrated today</source>
        <translation>cambiato dopo la calibrazione di oggi</translation>
    </message>
    <message>
        <source>changed since it was calibrated yesterday</source>
        <translation>cambiato dopo la calibrazione di ieri</translation>
    </message>
    <message>
        <source>check the touchpad's connection</source>
        <translation>controllare il collegamento del touchpad</translation>
    </message>
    <message>
        <source>check the weights, and that nothing rubs on the cell</source>
        <translation>controllare i pesi, e che nulla sfreghi sulla cella</translation>
    </message>
    <message>
        <source>chirp</source>
        <translation>chirp</translation>
    </message>
    <message>
        <source>classic robot, listening on {}</source>
        <translation>robot classico, in ascolto su {}</translation>
    </message>
    <message>
        <source>classic, not secured</source>
        <translation>classico, non protetto</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>tagliato</translation>
    </message>
    <message>
        <source>clock</source>
        <translation>orologio</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>chiuso</translation>
    </message>
    <message>
        <source>closed loop: the recording does not say how the cloth answers: {}</source>
        <translation>anello chiuso: la registrazione non dice come risponde il tessuto: {}</translation>
    </message>
    <message>
        <source>closing</source>
        <translation>in chiusura</translation>
    </message>
    <message>
        <source>cloth table: "{}" where "{}" was expected</source>
        <translation>tabella del tessuto: "{}" dove era atteso "{}"</translation>
    </message>
    <message>
        <source>cloth table: does not begin with "fyd-cloth 1"</source>
        <translation>tabella del tessuto: non comincia con "fyd-cloth 1"</translation>
    </message>
    <message>
        <source>cloth table: ends before "{}"</source>
        <translation>tabella del tessuto: finisce prima di "{}"</translation>
    </message>
    <message>
        <source>cloth table: expected two half sides, one distance and two reference stiffnesses, all above 0</source>
        <translation>tabella del tessuto: attesi due semilati, una distanza e due rigidezze di riferimento, tutti maggiori di 0</translation>
    </message>
    <message>
        <source>cloth table: no line "finger"</source>
        <translation>tabella del tessuto: nessuna riga "finger"</translation>
    </message>
    <message>
        <source>cloth table: shape: expected one number, 3 … {}</source>
        <translation>tabella del tessuto: shape: atteso un numero, 3 … {}</translation>
    </message>
    <message>
        <source>cloth table: x from 0, depth above 0</source>
        <translation>tabella del tessuto: x da 0, profondità maggiore di 0</translation>
    </message>
    <message>
        <source>cloth table: {} holds something that is no number</source>
        <translation>tabella del tessuto: {} contiene qualcosa che non è un numero</translation>
    </message>
    <message>
        <source>cloth table: {} holds {}, expected finite numbers</source>
        <translation>tabella del tessuto: {} contiene {}, attesi numeri finiti</translation>
    </message>
    <message>
        <source>cloth table: {}: expected 2 … {} rising numbers</source>
        <translation>tabella del tessuto: {}: attesi 2 … {} numeri crescenti</translation>
    </message>
    <message>
        <source>cloth table: {}: {} of {} numbers</source>
        <translation>tabella del tessuto: {}: {} di {} numeri</translation>
    </message>
    <message>
        <source>command</source>
        <translation>comando</translation>
    </message>
    <message>
        <source>commanded</source>
        <translation>comandato</translation>
    </message>
    <message>
        <source>commanded joint</source>
        <translation>giunto comandato</translation>
    </message>
    <message>
        <source>commanded joint plus its offset</source>
        <translation>giunto comandato più il suo scarto</translation>
    </message>
    <message>
        <source>commands and counts differ in number, or there are none</source>
        <translation>comandi e conteggi sono in numero diverso, o mancano</translation>
    </message>
    <message>
        <source>commit {} of {}</source>
        <translation>conferma {} di {}</translation>
    </message>
    <message>
        <source>compressed bytes are damaged ({})</source>
        <translation>i byte compressi sono danneggiati ({})</translation>
    </message>
    <message>
        <source>condition '{}' is given twice</source>
        <translation>la condizione '{}' è data due volte</translation>
    </message>
    <message>
        <source>condition number {:.3g}</source>
        <translation>numero di condizionamento {:.3g}</translation>
    </message>
    <message>
        <source>confirmed</source>
        <translation>confermato</translation>
    </message>
    <message>
        <source>connections</source>
        <translation>connessioni</translation>
    </message>
    <message>
        <source>contact '{}': this program does not know it</source>
        <translation>contatto '{}': questo programma non lo conosce</translation>
    </message>
    <message>
        <source>contact and membrane use the shape of the pushed cloth and a Kalman filter, contact with the area that the camera sees; thesis a plane, 0.8/0.2 and a 2 mm gate.</source>
        <translation>contact e membrane usano la forma del tessuto premuto e un filtro di Kalman, contact con l'area che la telecamera vede; thesis un piano, 0,8/0,2 e una soglia di 2 mm.</translation>
    </message>
    <message>
        <source>contrast</source>
        <translation>contrasto</translation>
    </message>
    <message>
        <source>control.law_angle_deg: {} points; expected at least 2</source>
        <translation>control.law_angle_deg: {} punti; attesi almeno 2</translation>
    </message>
    <message>
        <source>control.law_stiffness_N_per_mm: {} values for {} angles; expected one for each</source>
        <translation>control.law_stiffness_N_per_mm: {} valori per {} angoli; atteso uno per ciascuno</translation>
    </message>
    <message>
        <source>control.law_stiffness_N_per_mm: {}; expected above 0</source>
        <translation>control.law_stiffness_N_per_mm: {}; atteso oltre 0</translation>
    </message>
    <message>
        <source>control.travel_maximum_deg = {}: expected more than control.travel_minimum_deg = {}</source>
        <translation>control.travel_maximum_deg = {}: atteso più di control.travel_minimum_deg = {}</translation>
    </message>
    <message>
        <source>cookie</source>
        <translation>cookie</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>conteggi</translation>
    </message>
    <message>
        <source>counts against its motor</source>
        <translation>conta contro il suo motore</translation>
    </message>
    <message>
        <source>counts with its motor</source>
        <translation>conta con il suo motore</translation>
    </message>
    <message>
        <source>coupling "{}": expected one of {}</source>
        <translation>accoppiamento "{}": atteso uno di {}</translation>
    </message>
    <message>
        <source>current {}</source>
        <translation>corrente {}</translation>
    </message>
    <message>
        <source>curve: %1</source>
        <translation>curva: %1</translation>
    </message>
    <message>
        <source>cut short: its last {} of {} bytes are missing</source>
        <translation>tronco: mancano i suoi ultimi {} di {} byte</translation>
    </message>
    <message>
        <source>dB re 1 m/s²</source>
        <translation>dB rif. 1 m/s²</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>danneggiata</translation>
    </message>
    <message>
        <source>damaged pictures</source>
        <translation>immagini danneggiate</translation>
    </message>
    <message>
        <source>damaged: {} compressed bytes do not give the {} they should</source>
        <translation>danneggiato: {} byte compressi non danno i {} che dovrebbero</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>smorzamento</translation>
    </message>
    <message>
        <source>dashed</source>
        <translation>tratteggiata</translation>
    </message>
    <message>
        <source>days left</source>
        <translation>giorni rimasti</translation>
    </message>
    <message>
        <source>deadband {} %: expected 0 (none) … 100</source>
        <translation>banda morta {} %: atteso da 0 (nessuna) a 100</translation>
    </message>
    <message>
        <source>default %1</source>
        <translation>predefinito %1</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>°</translation>
    </message>
    <message>
        <source>delay {} ms: expected 0 … {}</source>
        <translation>ritardo {} ms: atteso 0 … {}</translation>
    </message>
    <message>
        <source>deleting of preset %1</source>
        <translation>eliminazione della preimpostazione %1</translation>
    </message>
    <message>
        <source>device restarts</source>
        <translation>riavvii del dispositivo</translation>
    </message>
    <message>
        <source>device test '{}': {}</source>
        <translation>prova del dispositivo '{}': {}</translation>
    </message>
    <message>
        <source>device test {}: no test has this number</source>
        <translation>prova del dispositivo {}: nessuna prova ha questo numero</translation>
    </message>
    <message>
        <source>device test: the session is closed</source>
        <translation>prova del dispositivo: la sessione è chiusa</translation>
    </message>
    <message>
        <source>device {}: none is plugged in; {} holds {}</source>
        <translation>dispositivo {}: nessuno è collegato; {} contiene {}</translation>
    </message>
    <message>
        <source>device {}: {} fit: {}; name more of the one that is meant</source>
        <translation>dispositivo {}: {} corrispondono: {}; precisare quale si intende</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>differisce</translation>
    </message>
    <message>
        <source>disconnect</source>
        <translation>scollegare</translation>
    </message>
    <message>
        <source>distance readings missing or too old</source>
        <translation>letture di distanza assenti o troppo vecchie</translation>
    </message>
    <message>
        <source>distance sensor {} did not read in any press</source>
        <translation>il sensore di distanza {} non ha letto in nessuna pressione</translation>
    </message>
    <message>
        <source>distance sensor {} does not read: look under Devices</source>
        <translation>il sensore di distanza {} non legge: guardare in Dispositivi</translation>
    </message>
    <message>
        <source>distance sensor {} reads {:.0f} counts, outside its span: look whether something stands before it</source>
        <translation>il sensore di distanza {} legge {:.0f} conteggi, fuori dal suo campo: guardare se c'è qualcosa davanti</translation>
    </message>
    <message>
        <source>distances to the untouched cloth {} mm, spread {:.2f} mm; force {:.3f} N</source>
        <translation>distanze dal tessuto non toccato {} mm, dispersione {:.2f} mm; forza {:.3f} N</translation>
    </message>
    <message>
        <source>does not fall over its whole span</source>
        <translation>non decresce su tutto il suo campo</translation>
    </message>
    <message>
        <source>does not settle</source>
        <translation>non si assesta</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fatto</translation>
    </message>
    <message>
        <source>dotted</source>
        <translation>punteggiata</translation>
    </message>
    <message>
        <source>drift from first to last point %1 ± %2</source>
        <translation>deriva dal primo all'ultimo punto %1 ± %2</translation>
    </message>
    <message>
        <source>duration {} s: expected 0 or more</source>
        <translation>durata {} s: atteso 0 o più</translation>
    </message>
    <message>
        <source>each ±%1 %2</source>
        <translation>ciascuno ±%1 %2</translation>
    </message>
    <message>
        <source>encoder %1: %2, zero at %3 counts, swept from %4 to %5</source>
        <translation>encoder %1: %2, zero a %3 conteggi, percorso da %4 a %5</translation>
    </message>
    <message>
        <source>encoder counts {}, expected 0 to {}</source>
        <translation>conteggi degli encoder {}, attesi da 0 a {}</translation>
    </message>
    <message>
        <source>encoder {}</source>
        <translation>encoder {}</translation>
    </message>
    <message>
        <source>encoder {} jumped by {:.0f}° in {:.0f} ms: check its magnet and cable, then arm again</source>
        <translation>l'encoder {} è saltato di {:.0f}° in {:.0f} ms: controllare magnete e cavo, poi armare di nuovo</translation>
    </message>
    <message>
        <source>encoder {} stands still although its motor was sent {:.0f}° further: check the motors' supply and the encoder's cable, then arm again</source>
        <translation>l'encoder {} è fermo benché il suo motore sia stato mandato {:.0f}° più in là: controllare l'alimentazione dei motori e il cavo dell'encoder, poi armare di nuovo</translation>
    </message>
    <message>
        <source>ended: a motor did not follow its commanded angle; check its encoder and that it can turn</source>
        <translation>terminata: un motore non ha seguito l'angolo comandato; controllare il suo encoder e che possa girare</translation>
    </message>
    <message>
        <source>ended: the button was released</source>
        <translation>terminata: il pulsante è stato lasciato</translation>
    </message>
    <message>
        <source>ended: the haptic loop stood still</source>
        <translation>terminata: il ciclo aptico si è fermato</translation>
    </message>
    <message>
        <source>ended: the session was stopped or armed</source>
        <translation>terminata: la sessione è stata fermata o armata</translation>
    </message>
    <message>
        <source>ended: the session's state changed</source>
        <translation>terminata: lo stato della sessione è cambiato</translation>
    </message>
    <message>
        <source>error of the fit %1</source>
        <translation>errore dell'adattamento %1</translation>
    </message>
    <message>
        <source>event</source>
        <translation>evento</translation>
    </message>
    <message>
        <source>exception 10: the gateway has no path to it</source>
        <translation>eccezione 10: il gateway non ha una via verso di esso</translation>
    </message>
    <message>
        <source>exception 11: the gateway gets no answer from it; is it switched on?</source>
        <translation>eccezione 11: il gateway non riceve risposta da esso; è acceso?</translation>
    </message>
    <message>
        <source>exception 1: it does not know this function; is it a touchpad with this register map?</source>
        <translation>eccezione 1: non conosce questa funzione; è un touchpad con questa mappa dei registri?</translation>
    </message>
    <message>
        <source>exception 2: it has no such register; is it a touchpad with this register map?</source>
        <translation>eccezione 2: non ha questo registro; è un touchpad con questa mappa dei registri?</translation>
    </message>
    <message>
        <source>exception 3: it refuses the value</source>
        <translation>eccezione 3: rifiuta il valore</translation>
    </message>
    <message>
        <source>exception 4: it failed; see the touchpad's own display or log</source>
        <translation>eccezione 4: non è riuscito; vedere il display o il registro del touchpad</translation>
    </message>
    <message>
        <source>exception 5: it needs longer</source>
        <translation>eccezione 5: gli serve più tempo</translation>
    </message>
    <message>
        <source>exception 6: it is busy, another program drives its motors; close that one</source>
        <translation>eccezione 6: è occupato, un altro programma comanda i suoi motori; chiuderlo</translation>
    </message>
    <message>
        <source>exception 7: it cannot do this</source>
        <translation>eccezione 7: non può farlo</translation>
    </message>
    <message>
        <source>exception 8: memory parity error</source>
        <translation>eccezione 8: errore di parità della memoria</translation>
    </message>
    <message>
        <source>excitation at {} s: angle {}°; expected numbers</source>
        <translation>eccitazione a {} s: angolo {}°; attesi numeri</translation>
    </message>
    <message>
        <source>excitation: stiffness observable in {} samples over {:.2f} s; expected at least {} over {} s</source>
        <translation>eccitazione: rigidezza osservabile in {} campioni su {:.2f} s; attesi almeno {} su {} s</translation>
    </message>
    <message>
        <source>excitation: stretch {:.1f}…{:.1f}° moves the law by {:.1f} %; expected at least {:.0f} %</source>
        <translation>eccitazione: la tensione {:.1f}…{:.1f}° muove la legge del {:.1f} %; atteso almeno il {:.0f} %</translation>
    </message>
    <message>
        <source>excitation: the model explains {:.0f} % of the measured stiffness' changes; expected at least {:.0f} %</source>
        <translation>eccitazione: il modello spiega il {:.0f} % delle variazioni della rigidezza misurata; atteso almeno il {:.0f} %</translation>
    </message>
    <message>
        <source>excitation: {} s after {} s; expected time to rise</source>
        <translation>eccitazione: {} s dopo {} s; il tempo deve crescere</translation>
    </message>
    <message>
        <source>expected [[record]]</source>
        <translation>atteso [[record]]</translation>
    </message>
    <message>
        <source>expected a camera that Video4Linux can read, and the right to open it</source>
        <translation>attesa una telecamera che Video4Linux sappia leggere, e il diritto di aprirla</translation>
    </message>
    <message>
        <source>expected a stream that FFmpeg can play and that starts within 3 s</source>
        <translation>atteso un flusso che FFmpeg sappia riprodurre e che cominci entro 3 s</translation>
    </message>
    <message>
        <source>expected a video that FFmpeg can decode</source>
        <translation>atteso un video che FFmpeg sappia decodificare</translation>
    </message>
    <message>
        <source>exposure</source>
        <translation>esposizione</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>guasto</translation>
    </message>
    <message>
        <source>fault '{}': expected NAME@SECONDS or NAME@SECONDS+DURATION with one of {}</source>
        <translation>guasto '{}': atteso NAME@SECONDS o NAME@SECONDS+DURATION con uno di {}</translation>
    </message>
    <message>
        <source>fault reaction active</source>
        <translation>reazione al guasto in corso</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>sentito</translation>
    </message>
    <message>
        <source>field</source>
        <translation>campo</translation>
    </message>
    <message>
        <source>field "{}": asked for twice</source>
        <translation>campo "{}": chiesto due volte</translation>
    </message>
    <message>
        <source>field "{}": there is none of this name; there are {}</source>
        <translation>campo "{}": non esiste con questo nome; ci sono {}</translation>
    </message>
    <message>
        <source>field {} of {}</source>
        <translation>campo {} di {}</translation>
    </message>
    <message>
        <source>figures from {} s to {} s: expected two times</source>
        <translation>valori da {} s a {} s: attesi due tempi</translation>
    </message>
    <message>
        <source>file missing</source>
        <translation>file mancante</translation>
    </message>
    <message>
        <source>filter: {}</source>
        <translation>filtro: {}</translation>
    </message>
    <message>
        <source>fine: calibrated %1 days ago</source>
        <translation>a posto: calibrato %1 giorni fa</translation>
    </message>
    <message>
        <source>fine: calibrated today</source>
        <translation>a posto: calibrato oggi</translation>
    </message>
    <message>
        <source>fine: calibrated yesterday</source>
        <translation>a posto: calibrato ieri</translation>
    </message>
    <message>
        <source>finger</source>
        <translation>dito</translation>
    </message>
    <message>
        <source>finger '{}': only the simulated touchpad has a simulated finger</source>
        <translation>dito '{}': solo il touchpad simulato ha un dito simulato</translation>
    </message>
    <message>
        <source>finger ({:.0f}) and cloth ({:.0f}) are not told apart: put a finger on the cloth, or more light behind it</source>
        <translation>dito ({:.0f}) e tessuto ({:.0f}) non si distinguono: mettere un dito sul tessuto, o più luce dietro</translation>
    </message>
    <message>
        <source>finger at {:.0f}, cloth at {:.0f}, threshold {}</source>
        <translation>dito a {:.0f}, tessuto a {:.0f}, soglia {}</translation>
    </message>
    <message>
        <source>finger_mm of a soft body is {}; expected more than 0</source>
        <translation>finger_mm di un corpo morbido è {}; atteso più di 0</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>finita</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>firmware</translation>
    </message>
    <message>
        <source>first</source>
        <translation>primo</translation>
    </message>
    <message>
        <source>first scale</source>
        <translation>scala del primo</translation>
    </message>
    <message>
        <source>first zero</source>
        <translation>zero del primo</translation>
    </message>
    <message>
        <source>flat picture</source>
        <translation>immagine piatta</translation>
    </message>
    <message>
        <source>flow {} bit/s: expected more than 0</source>
        <translation>flusso {} bit/s: atteso più di 0</translation>
    </message>
    <message>
        <source>folder</source>
        <translation>cartella</translation>
    </message>
    <message>
        <source>folder {}, {} pictures at {:.0f} fps, repeating</source>
        <translation>cartella {}, {} immagini a {:.0f} fps, a ripetizione</translation>
    </message>
    <message>
        <source>folder: {}</source>
        <translation>cartella: {}</translation>
    </message>
    <message>
        <source>for %1</source>
        <translation>da %1</translation>
    </message>
    <message>
        <source>force</source>
        <translation>forza</translation>
    </message>
    <message>
        <source>force = {} N: expected {} … {}</source>
        <translation>force = {} N: atteso {} … {}</translation>
    </message>
    <message>
        <source>force too small</source>
        <translation>forza troppo piccola</translation>
    </message>
    <message>
        <source>force unavailable</source>
        <translation>forza non disponibile</translation>
    </message>
    <message>
        <source>found</source>
        <translation>trovato</translation>
    </message>
    <message>
        <source>frame = {}: expected 2 … {} samples</source>
        <translation>frame = {}: attesi 2 … {} campioni</translation>
    </message>
    <message>
        <source>from</source>
        <translation>da</translation>
    </message>
    <message>
        <source>from robot</source>
        <translation>dal robot</translation>
    </message>
    <message>
        <source>from the future</source>
        <translation>dal futuro</translation>
    </message>
    <message>
        <source>from the start</source>
        <translation>dall'inizio</translation>
    </message>
    <message>
        <source>from {} s to {} s: the first must not be larger than the second</source>
        <translation>da {} s a {} s: il primo non deve superare il secondo</translation>
    </message>
    <message>
        <source>front and back edges are free</source>
        <translation>i bordi davanti e dietro sono liberi</translation>
    </message>
    <message>
        <source>gain margin %1, phase margin %2</source>
        <translation>margine di guadagno %1, margine di fase %2</translation>
    </message>
    <message>
        <source>gains of the chirps from {:.2f} to {:.2f}; expected them within a factor of {}</source>
        <translation>guadagni degli sweep da {:.2f} a {:.2f}; attesi entro un fattore di {}</translation>
    </message>
    <message>
        <source>gesture "{}": {} rows from {} to {} s: expected two and more of its {} s</source>
        <translation>gesto "{}": {} righe da {} a {} s: attese due o più dei suoi {} s</translation>
    </message>
    <message>
        <source>gesture: {} rows: expected two and more</source>
        <translation>gesto: {} righe: attese due o più</translation>
    </message>
    <message>
        <source>go to, s</source>
        <translation>vai a, s</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>sparito</translation>
    </message>
    <message>
        <source>good</source>
        <translation>buona</translation>
    </message>
    <message>
        <source>handshake</source>
        <translation>saluto</translation>
    </message>
    <message>
        <source>has said goodbye</source>
        <translation>si è congedato</translation>
    </message>
    <message>
        <source>has switched its motors off by itself</source>
        <translation>ha spento i motori da sola</translation>
    </message>
    <message>
        <source>heartbeat lost</source>
        <translation>battito perso</translation>
    </message>
    <message>
        <source>height</source>
        <translation>altezza</translation>
    </message>
    <message>
        <source>held and free edges fit nearly alike (error {:.2f} and {:.2f} mm): the edges are not proven</source>
        <translation>bordi tenuti e bordi liberi si adattano quasi ugualmente (errore {:.2f} e {:.2f} mm): i bordi non sono provati</translation>
    </message>
    <message>
        <source>held-out error {} of at most {:g} N over {} weights</source>
        <translation>errore di verifica {} su al più {:g} N con {} pesi</translation>
    </message>
    <message>
        <source>held-out error {} of at most {:g} N; stiffness rises from {:.3f} to {:.3f} N/mm</source>
        <translation>errore di verifica {} su al più {:g} N; la rigidezza cresce da {:.3f} a {:.3f} N/mm</translation>
    </message>
    <message>
        <source>held-out error {} of at most {:g} deg</source>
        <translation>errore di verifica {} su al più {:g}°</translation>
    </message>
    <message>
        <source>held-out error {} of at most {:g} mm</source>
        <translation>errore di verifica {} su al più {:g} mm</translation>
    </message>
    <message>
        <source>held-out error {} of at most {:g} mm; radius share {:.3f} ± {:.3f}, tension ratio {:.2f} ± {:.2f}; all edges are held</source>
        <translation>errore di verifica {} di al massimo {:g} mm; quota del raggio {:.3f} ± {:.3f}, rapporto di tensione {:.2f} ± {:.2f}; tutti i bordi sono tenuti</translation>
    </message>
    <message>
        <source>held-out error {} of at most {:g} mm; radius share {:.3f} ± {:.3f}, tension ratio {:.2f} ± {:.2f}; front and back edges are free: this cloth cannot be known better from such presses (about 0.7 mm and 20 % of stiffness)</source>
        <translation>errore di verifica {} di al massimo {:g} mm; quota del raggio {:.3f} ± {:.3f}, rapporto di tensione {:.2f} ± {:.2f}; i bordi davanti e dietro sono liberi: da tali pressioni questo tessuto non si può conoscere meglio (circa 0,7 mm e 20 % di rigidezza)</translation>
    </message>
    <message>
        <source>held-out error {}; expected at most {:g} N: {}</source>
        <translation>errore di verifica {}; atteso al più {:g} N: {}</translation>
    </message>
    <message>
        <source>held-out error {}; expected at most {:g} mm: tare, and press straight down over the middle of each sensor</source>
        <translation>errore di verifica {}; atteso al massimo {:g} mm: fare la tara e premere dritto sopra il centro di ogni sensore</translation>
    </message>
    <message>
        <source>held-out error {}; expected at most {:g} mm: {}</source>
        <translation>errore di verifica {}; atteso al più {:g} mm: {}</translation>
    </message>
    <message>
        <source>held-out error {}; expected at most {:g}: sweep slower, and wait at each angle</source>
        <translation>errore di verifica {}; atteso al più {:g}: muovere più piano, e attendere a ogni angolo</translation>
    </message>
    <message>
        <source>histogram</source>
        <translation>istogramma</translation>
    </message>
    <message>
        <source>hop = {}: expected a divisor of the frame, {} (blocks) or less (overlapped)</source>
        <translation>hop = {}: atteso un divisore del frame, {} (blocchi) o meno (sovrapposti)</translation>
    </message>
    <message>
        <source>hysteresis %1</source>
        <translation>isteresi %1</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>in attesa</translation>
    </message>
    <message>
        <source>images off</source>
        <translation>immagini no</translation>
    </message>
    <message>
        <source>images on</source>
        <translation>immagini sì</translation>
    </message>
    <message>
        <source>indentation too small</source>
        <translation>indentazione troppo piccola</translation>
    </message>
    <message>
        <source>indentation unavailable</source>
        <translation>indentazione non disponibile</translation>
    </message>
    <message>
        <source>inverse, a/(v + b) + c</source>
        <translation>inversa, a/(v + b) + c</translation>
    </message>
    <message>
        <source>is %1</source>
        <translation>è %1</translation>
    </message>
    <message>
        <source>its first bytes cannot be read</source>
        <translation>i suoi primi byte non si possono leggere</translation>
    </message>
    <message>
        <source>its header is damaged: the checksum differs</source>
        <translation>la sua intestazione è danneggiata: la somma di controllo è diversa</translation>
    </message>
    <message>
        <source>its lock cannot be had, it may be recorded at this moment: {}</source>
        <translation>il suo blocco non si può ottenere, forse è in registrazione in questo momento: {}</translation>
    </message>
    <message>
        <source>its recorder is gone; make it whole with: fyd session recover</source>
        <translation>il suo registratore non c'è più; renderla intera con: fyd session recover</translation>
    </message>
    <message>
        <source>jerk limit {} mm/s³: expected 1000 to 10000000</source>
        <translation>limite di strappo {} mm/s³: atteso da 1000 a 10000000</translation>
    </message>
    <message>
        <source>jitter {} ms: expected 0 … {}</source>
        <translation>jitter {} ms: atteso 0 … {}</translation>
    </message>
    <message>
        <source>joint impedance</source>
        <translation>impedenza dei giunti</translation>
    </message>
    <message>
        <source>key</source>
        <translation>chiave</translation>
    </message>
    <message>
        <source>key file {}: exists already; a key is never overwritten</source>
        <translation>file della chiave {}: esiste già; una chiave non viene mai sovrascritta</translation>
    </message>
    <message>
        <source>key file {}: longer than {} bytes; not a key</source>
        <translation>file della chiave {}: più lungo di {} byte; non è una chiave</translation>
    </message>
    <message>
        <source>key file {}: not a regular file</source>
        <translation>file della chiave {}: non è un file normale</translation>
    </message>
    <message>
        <source>key file {}: open to others (mode {:04o}); make it private with: chmod 600 {}</source>
        <translation>file della chiave {}: aperto ad altri (modo {:04o}); renderlo privato con: chmod 600 {}</translation>
    </message>
    <message>
        <source>key file {}: {}</source>
        <translation>file della chiave {}: {}</translation>
    </message>
    <message>
        <source>kind "{}"; expected note or bookmark</source>
        <translation>tipo "{}"; atteso note o bookmark</translation>
    </message>
    <message>
        <source>largest %1 at %2</source>
        <translation>massimo %1 a %2</translation>
    </message>
    <message>
        <source>largest residual %1</source>
        <translation>residuo maggiore %1</translation>
    </message>
    <message>
        <source>last touch</source>
        <translation>ultimo tocco</translation>
    </message>
    <message>
        <source>late</source>
        <translation>in ritardo</translation>
    </message>
    <message>
        <source>lay the target flat and set the camera square to it</source>
        <translation>stendere piano il bersaglio e mettere la telecamera perpendicolare</translation>
    </message>
    <message>
        <source>lead of {} ms: expected 0 to 500</source>
        <translation>anticipo di {} ms: atteso da 0 a 500</translation>
    </message>
    <message>
        <source>left and right</source>
        <translation>a sinistra e a destra</translation>
    </message>
    <message>
        <source>left as it is</source>
        <translation>lasciato com'è</translation>
    </message>
    <message>
        <source>less</source>
        <translation>in meno</translation>
    </message>
    <message>
        <source>let the motors and the cloth come to rest, and start again</source>
        <translation>lasciare fermare motori e tessuto, e ricominciare</translation>
    </message>
    <message>
        <source>lies on the other's</source>
        <translation>sta su quello dell'altra</translation>
    </message>
    <message>
        <source>light unknown</source>
        <translation>luce sconosciuta</translation>
    </message>
    <message>
        <source>light, temperature, target</source>
        <translation>luce, temperatura, bersaglio</translation>
    </message>
    <message>
        <source>limit reached before two samples</source>
        <translation>limite raggiunto prima di due campioni</translation>
    </message>
    <message>
        <source>line</source>
        <translation>retta</translation>
    </message>
    <message>
        <source>live</source>
        <translation>dal vivo</translation>
    </message>
    <message>
        <source>live, peak</source>
        <translation>vivo, picco</translation>
    </message>
    <message>
        <source>load cell</source>
        <translation>cella di carico</translation>
    </message>
    <message>
        <source>load cell: {:.3f} mV/V lies beyond the bridge's span</source>
        <translation>cella di carico: {:.3f} mV/V è oltre il campo del ponte</translation>
    </message>
    <message>
        <source>loading reads {:.3f} N apart from unloading: look for friction between the cell and its plate</source>
        <translation>il carico differisce di {:.3f} N dallo scarico: cercare attrito fra cella e piastra</translation>
    </message>
    <message>
        <source>longest_step_s of a soft body is {}; expected more than 0</source>
        <translation>longest_step_s di un corpo morbido è {}; atteso più di 0</translation>
    </message>
    <message>
        <source>look at the distance sensors' curves and at the load cell's cable</source>
        <translation>guardare le curve dei sensori di distanza e il cavo della cella di carico</translation>
    </message>
    <message>
        <source>loss {} %: expected 0 … 100</source>
        <translation>perdita {} %: attesa 0 … 100</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>perso</translation>
    </message>
    <message>
        <source>m/s²</source>
        <translation>m/s²</translation>
    </message>
    <message>
        <source>mJ</source>
        <translation>mJ</translation>
    </message>
    <message>
        <source>mass_kg of a soft body is {}; expected 0 or more</source>
        <translation>mass_kg di un corpo morbido è {}; atteso 0 o più</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>media</translation>
    </message>
    <message>
        <source>mean x</source>
        <translation>media x</translation>
    </message>
    <message>
        <source>mean y</source>
        <translation>media y</translation>
    </message>
    <message>
        <source>mean z</source>
        <translation>media z</translation>
    </message>
    <message>
        <source>measure the outliers again</source>
        <translation>misurare di nuovo i valori anomali</translation>
    </message>
    <message>
        <source>measure the outliers again, or leave them out</source>
        <translation>misurare di nuovo i valori anomali, o escluderli</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>misurato</translation>
    </message>
    <message>
        <source>measured joint</source>
        <translation>giunto misurato</translation>
    </message>
    <message>
        <source>measured with another calibration: measure it again</source>
        <translation>misurata con un'altra calibrazione: misurarla di nuovo</translation>
    </message>
    <message>
        <source>measured without the invalid sensors</source>
        <translation>misurato senza i sensori non validi</translation>
    </message>
    <message>
        <source>membrane: radius share and tension ratio</source>
        <translation>membrana: quota del raggio e rapporto di tensione</translation>
    </message>
    <message>
        <source>message</source>
        <translation>messaggio</translation>
    </message>
    <message>
        <source>method number {}: unknown</source>
        <translation>metodo numero {}: sconosciuto</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>monitor</source>
        <translation>monitor</translation>
    </message>
    <message>
        <source>more</source>
        <translation>in più</translation>
    </message>
    <message>
        <source>more than 5 % of the haptic cycles of one second were missed</source>
        <translation>più del 5 % dei cicli aptici di un secondo è mancato</translation>
    </message>
    <message>
        <source>most_parts of a soft body is {}; expected 1 or more</source>
        <translation>most_parts di un corpo morbido è {}; atteso 1 o più</translation>
    </message>
    <message>
        <source>most_points of a soft body is {}; expected 3 or more</source>
        <translation>most_points di un corpo morbido è {}; atteso 3 o più</translation>
    </message>
    <message>
        <source>motor 1</source>
        <translation>motore 1</translation>
    </message>
    <message>
        <source>motor 2</source>
        <translation>motore 2</translation>
    </message>
    <message>
        <source>motor board {} at {} does not obey: its motors are on, expected off; switch off its supply</source>
        <translation>scheda motori {} su {} non obbedisce: i suoi motori sono accesi, attesi spenti; spegnerne l'alimentazione</translation>
    </message>
    <message>
        <source>motor board {} at {} {}: mend that, then arm again</source>
        <translation>scheda motori {} su {} {}: porvi rimedio, poi armare di nuovo</translation>
    </message>
    <message>
        <source>motor board {} at {}, {} Bd</source>
        <translation>scheda motori {} su {}, {} Bd</translation>
    </message>
    <message>
        <source>motor board {} at {}, {} Bd, no vibration (device.qbmove_vibration_opcode is not set)</source>
        <translation>scheda motori {} su {}, {} Bd, senza vibrazione (device.qbmove_vibration_opcode non è impostato)</translation>
    </message>
    <message>
        <source>motor board {} at {}: current {} is {} mA, expected -{} to {}</source>
        <translation>scheda motori {} su {}: la corrente {} è di {} mA, attesa da -{} a {}</translation>
    </message>
    <message>
        <source>motor board {} at {}: no answer to command {} in {} ms; is it on, and are device.qbmove_baud = {} and device.qbmove_id right?</source>
        <translation>scheda motori {} su {}: nessuna risposta al comando {} in {} ms; è accesa, e device.qbmove_baud = {} e device.qbmove_id sono giusti?</translation>
    </message>
    <message>
        <source>motor board: nothing received yet</source>
        <translation>scheda motori: ancora niente ricevuto</translation>
    </message>
    <message>
        <source>motor currents {} mA, expected -{} to {}</source>
        <translation>correnti dei motori {} mA, attese da -{} a {}</translation>
    </message>
    <message>
        <source>motor over-temperature</source>
        <translation>motore surriscaldato</translation>
    </message>
    <message>
        <source>motor reference off</source>
        <translation>riferimento motori no</translation>
    </message>
    <message>
        <source>motor reference on</source>
        <translation>riferimento motori sì</translation>
    </message>
    <message>
        <source>motor temperatures {} °C, expected {} to {}</source>
        <translation>temperature dei motori {} °C, attese da {} a {}</translation>
    </message>
    <message>
        <source>motor {} stands at {:.1f}°, beyond control.motor_limit_deg = {:.0f}: check the encoder's zero</source>
        <translation>il motore {} sta a {:.1f}°, oltre control.motor_limit_deg = {:.0f}: controllare lo zero dell'encoder</translation>
    </message>
    <message>
        <source>motors</source>
        <translation>motori</translation>
    </message>
    <message>
        <source>motors %1</source>
        <translation>motori %1</translation>
    </message>
    <message>
        <source>motors '{}': a recording drives no motors</source>
        <translation>motori '{}': una registrazione non comanda motori</translation>
    </message>
    <message>
        <source>motors '{}': expected qbmove:TTY</source>
        <translation>motori '{}': atteso qbmove:TTY</translation>
    </message>
    <message>
        <source>motors and cloth identified</source>
        <translation>motori e tessuto identificati</translation>
    </message>
    <message>
        <source>motors at {:.0f} and {:.0f} °C, switched off at {:.0f}: let them cool</source>
        <translation>motori a {:.0f} e {:.0f} °C, spenti a {:.0f}: lasciarli raffreddare</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>in moto</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>network profile "{}": expected isdn, adsl, lan or a CSV file</source>
        <translation>profilo di rete "{}": atteso isdn, adsl, lan o un file CSV</translation>
    </message>
    <message>
        <source>network {} {} {}: expected 0 to {}</source>
        <translation>rete {} {} {}: atteso da 0 a {}</translation>
    </message>
    <message>
        <source>never calibrated</source>
        <translation>mai calibrato</translation>
    </message>
    <message>
        <source>no JPEG decoder: {}</source>
        <translation>nessun decodificatore JPEG: {}</translation>
    </message>
    <message>
        <source>no answer in {:.0f} ms; is it switched on and connected?</source>
        <translation>nessuna risposta in {:.0f} ms; è acceso e collegato?</translation>
    </message>
    <message>
        <source>no answer yet</source>
        <translation>ancora nessuna risposta</translation>
    </message>
    <message>
        <source>no catalogue was chosen</source>
        <translation>nessun catalogo è stato scelto</translation>
    </message>
    <message>
        <source>no commit in it can be trusted: all {} are damaged</source>
        <translation>nessuna conferma in essa è affidabile: tutte le {} sono danneggiate</translation>
    </message>
    <message>
        <source>no commit in it can be trusted: nothing was ever completely written</source>
        <translation>nessuna conferma in essa è affidabile: nulla è mai stato scritto per intero</translation>
    </message>
    <message>
        <source>no contact within the travel limit</source>
        <translation>nessun contatto entro il limite di corsa</translation>
    </message>
    <message>
        <source>no curve can be used ({}): add points, spread over 40 to 300 mm</source>
        <translation>nessuna curva è utilizzabile ({}): aggiungere punti, distribuiti da 40 a 300 mm</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>nessun dato</translation>
    </message>
    <message>
        <source>no device tells '{}': look under Devices whether the touchpad answers</source>
        <translation>nessun dispositivo riferisce '{}': guardare in Dispositivi se il touchpad risponde</translation>
    </message>
    <message>
        <source>no finger</source>
        <translation>nessun dito</translation>
    </message>
    <message>
        <source>no force is measured: look at the load cell's cable</source>
        <translation>nessuna forza misurata: guardare il cavo della cella di carico</translation>
    </message>
    <message>
        <source>no indentation is measured: press the cloth with a finger</source>
        <translation>nessuna indentazione misurata: premere il tessuto con un dito</translation>
    </message>
    <message>
        <source>no picture</source>
        <translation>nessuna immagine</translation>
    </message>
    <message>
        <source>no picture from {} s to {} s</source>
        <translation>nessuna immagine da {} s a {} s</translation>
    </message>
    <message>
        <source>no picture was taken up to {} s</source>
        <translation>nessuna immagine è stata presa fino a {} s</translation>
    </message>
    <message>
        <source>no place yet: click a mark of the target in the picture</source>
        <translation>ancora nessuna posizione: fare clic su un segno del bersaglio nell'immagine</translation>
    </message>
    <message>
        <source>no point between {:g} and {:g} mm, {:.0f} % of the span: add points between {:g} and {:g} mm</source>
        <translation>nessun punto tra {:g} e {:g} mm, {:.0f} % del campo: aggiungere punti tra {:g} e {:g} mm</translation>
    </message>
    <message>
        <source>no points: add points between 40 and 300 mm</source>
        <translation>nessun punto: aggiungere punti tra 40 e 300 mm</translation>
    </message>
    <message>
        <source>no press at {:.3g} deg is deeper than {:.3g} mm; expected at least {:g} mm: press deeper there</source>
        <translation>nessuna pressione a {:.3g} gradi supera {:.3g} mm; servono almeno {:g} mm: premere di più lì</translation>
    </message>
    <message>
        <source>no press is within {:g} mm of a distance sensor that reads: press over each sensor</source>
        <translation>nessuna pressione è entro {:g} mm da un sensore di distanza che legge: premere sopra ogni sensore</translation>
    </message>
    <message>
        <source>no press over distance sensor {}: press over each sensor, at two depths</source>
        <translation>nessuna pressione sopra il sensore di distanza {}: premere sopra ogni sensore, a due profondità</translation>
    </message>
    <message>
        <source>no problem</source>
        <translation>nessun problema</translation>
    </message>
    <message>
        <source>no program that this user can see</source>
        <translation>nessun programma che questo utente possa vedere</translation>
    </message>
    <message>
        <source>no ramp of motor {} with {} duty; expected each motor both ways</source>
        <translation>nessuna rampa del motore {} con duty {}; attesi entrambi i motori nei due versi</translation>
    </message>
    <message>
        <source>no recent picture</source>
        <translation>nessuna immagine recente</translation>
    </message>
    <message>
        <source>no region of interest from {} s to {} s</source>
        <translation>nessuna regione di interesse da {} s a {} s</translation>
    </message>
    <message>
        <source>no region yet: drag a rectangle around the cloth in the picture</source>
        <translation>ancora nessuna regione: trascinare un rettangolo attorno al tessuto nell'immagine</translation>
    </message>
    <message>
        <source>no robot has connected</source>
        <translation>nessun robot si è connesso</translation>
    </message>
    <message>
        <source>no samples from {} s to {} s: the recording has {}, to {:.3f} s</source>
        <translation>nessun campione da {} s a {} s: la registrazione ne ha {}, fino a {:.3f} s</translation>
    </message>
    <message>
        <source>no scene is shared</source>
        <translation>nessuna scena è condivisa</translation>
    </message>
    <message>
        <source>no stiffness target</source>
        <translation>nessuna rigidezza desiderata</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>il file non esiste</translation>
    </message>
    <message>
        <source>no threshold is suggested, the present one stays: {}</source>
        <translation>nessuna soglia è proposta, resta quella attuale: {}</translation>
    </message>
    <message>
        <source>no touchpad answered</source>
        <translation>nessun touchpad ha risposto</translation>
    </message>
    <message>
        <source>no touchpad with this key answered</source>
        <translation>nessun touchpad con questa chiave ha risposto</translation>
    </message>
    <message>
        <source>no value changes: the texture takes rest away by itself</source>
        <translation>nessun valore cambia: la texture toglie da sola il riposo</translation>
    </message>
    <message>
        <source>no video can be written: OpenCV has no coder for it, or the disk is full</source>
        <translation>non si può scrivere alcun video: OpenCV non ha un codificatore, o il disco è pieno</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nessuno</translation>
    </message>
    <message>
        <source>none since the start</source>
        <translation>nessuno dall'avvio</translation>
    </message>
    <message>
        <source>not FYD Link</source>
        <translation>non FYD Link</translation>
    </message>
    <message>
        <source>not a digit</source>
        <translation>non è una cifra</translation>
    </message>
    <message>
        <source>not a file</source>
        <translation>non è un file</translation>
    </message>
    <message>
        <source>not a recording, or too damaged to open</source>
        <translation>non è una registrazione, o è troppo danneggiata per aprirla</translation>
    </message>
    <message>
        <source>not confirmed: the station did not answer. It last used %1.</source>
        <translation>non confermato: la stazione non ha risposto. Da ultimo usava %1.</translation>
    </message>
    <message>
        <source>not enough experiments yet</source>
        <translation>non ancora abbastanza esperimenti</translation>
    </message>
    <message>
        <source>not identified</source>
        <translation>non identificati</translation>
    </message>
    <message>
        <source>not opened through the console's driver</source>
        <translation>non aperto attraverso il driver della console</translation>
    </message>
    <message>
        <source>not ready to switch on</source>
        <translation>non pronto ad accendersi</translation>
    </message>
    <message>
        <source>not told by this robot</source>
        <translation>non detto da questo robot</translation>
    </message>
    <message>
        <source>note</source>
        <translation>nota</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nulla</translation>
    </message>
    <message>
        <source>nothing is being recorded</source>
        <translation>nulla è in registrazione</translation>
    </message>
    <message>
        <source>nothing listens there; is the touchpad on and the port right?</source>
        <translation>lì non ascolta nulla; il touchpad è acceso e la porta giusta?</translation>
    </message>
    <message>
        <source>nothing missing</source>
        <translation>non manca nulla</translation>
    </message>
    <message>
        <source>nothing received yet</source>
        <translation>ancora nulla ricevuto</translation>
    </message>
    <message>
        <source>now</source>
        <translation>ora</translation>
    </message>
    <message>
        <source>number not finite</source>
        <translation>numero non finito</translation>
    </message>
    <message>
        <source>number out of range</source>
        <translation>numero fuori campo</translation>
    </message>
    <message>
        <source>observed</source>
        <translation>osservata</translation>
    </message>
    <message>
        <source>off</source>
        <translation>spento</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>scostamento</translation>
    </message>
    <message>
        <source>offset of the commanded</source>
        <translation>scarto del comandato</translation>
    </message>
    <message>
        <source>old: %1</source>
        <translation>vecchio: %1</translation>
    </message>
    <message>
        <source>on</source>
        <translation>acceso</translation>
    </message>
    <message>
        <source>once</source>
        <translation>una volta</translation>
    </message>
    <message>
        <source>one of {}</source>
        <translation>uno fra {}</translation>
    </message>
    <message>
        <source>only {} of {} frames could be written; is the disk full?</source>
        <translation>solo {} immagini su {} si sono potute scrivere; il disco è pieno?</translation>
    </message>
    <message>
        <source>operation enabled</source>
        <translation>in funzione</translation>
    </message>
    <message>
        <source>other</source>
        <translation>altro</translation>
    </message>
    <message>
        <source>other address</source>
        <translation>altro indirizzo</translation>
    </message>
    <message>
        <source>other session</source>
        <translation>altra sessione</translation>
    </message>
    <message>
        <source>other version</source>
        <translation>altra versione</translation>
    </message>
    <message>
        <source>out of reach</source>
        <translation>fuori portata</translation>
    </message>
    <message>
        <source>out of reach: less than is felt arrives</source>
        <translation>fuori portata: arriva meno di ciò che si sente</translation>
    </message>
    <message>
        <source>out of turn</source>
        <translation>fuori turno</translation>
    </message>
    <message>
        <source>outside {:.0f} to {:.0f} mm the sensor will count as invalid: the cloth rests at about 100 mm</source>
        <translation>fuori da {:.0f}–{:.0f} mm il sensore conterà come non valido: il tessuto a riposo sta a circa 100 mm</translation>
    </message>
    <message>
        <source>pairing code</source>
        <translation>codice di abbinamento</translation>
    </message>
    <message>
        <source>pairing code: the checksum does not fit; a word is another than it was, or the order is</source>
        <translation>codice di abbinamento: la somma di controllo non corrisponde; una parola è diversa da com'era, o lo è l'ordine</translation>
    </message>
    <message>
        <source>pairing code: word {} is not a pairing word; check its spelling</source>
        <translation>codice di abbinamento: la parola {} non è una parola di abbinamento; controllare come è scritta</translation>
    </message>
    <message>
        <source>pairing code: {} words; expected {}</source>
        <translation>codice di abbinamento: {} parole; attese {}</translation>
    </message>
    <message>
        <source>part {}: a chirp of {} s; expected {} s and more</source>
        <translation>parte {}: una scansione di {} s; attesi {} s o più</translation>
    </message>
    <message>
        <source>part {}: duty of motor {} goes from {} to {} %: expected a ramp in steps of at most {} %</source>
        <translation>parte {}: il duty del motore {} passa da {} a {} %: attesa una rampa a passi di al massimo {} %</translation>
    </message>
    <message>
        <source>part {}: motor {} did not turn up to a duty of {} %; expected a ramp until it turns</source>
        <translation>parte {}: il motore {} non ha girato fino a un duty del {} %; attesa una rampa finché gira</translation>
    </message>
    <message>
        <source>part {}: motor {} moves before it has a duty</source>
        <translation>parte {}: il motore {} si muove prima di avere un duty</translation>
    </message>
    <message>
        <source>part {}: neither a ramp of one motor nor a chirp of both with the same duty</source>
        <translation>parte {}: né una rampa di un motore né una scansione di entrambi con lo stesso duty</translation>
    </message>
    <message>
        <source>part {}: no acceleration_g at {} s; the chirp needs an accelerometer on the cloth: encoders, load cell and currents cannot see it</source>
        <translation>parte {}: nessuna acceleration_g a {} s; la scansione richiede un accelerometro sul tessuto: encoder, cella di carico e correnti non possono vederla</translation>
    </message>
    <message>
        <source>part {}: resonance {:.1f} ± {:.1f} Hz: not determined; expected ± {:.0f} % or better</source>
        <translation>parte {}: risonanza {:.1f} ± {:.1f} Hz: non determinata; atteso ± {:.0f} % o meglio</translation>
    </message>
    <message>
        <source>part {}: the model leaves {:.0f} % of the acceleration held out; expected at most {:.0f} %</source>
        <translation>parte {}: il modello lascia il {:.0f} % dell'accelerazione tenuta da parte; atteso al massimo il {:.0f} %</translation>
    </message>
    <message>
        <source>parts missing</source>
        <translation>parti mancanti</translation>
    </message>
    <message>
        <source>path '{}': expected an absolute one</source>
        <translation>percorso '{}': atteso uno assoluto</translation>
    </message>
    <message>
        <source>path: {}</source>
        <translation>percorso: {}</translation>
    </message>
    <message>
        <source>patience of {} ms: expected 1 to 10000</source>
        <translation>pazienza di {} ms: atteso da 1 a 10000</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>in pausa</translation>
    </message>
    <message>
        <source>perceptron: number {} is "{}"; expected one from {} to {}</source>
        <translation>percettrone: il numero {} è "{}"; atteso uno da {} a {}</translation>
    </message>
    <message>
        <source>perceptron: {} inputs, {} hidden units, {} outputs and {} weights; expected {}, {}, {} and {}</source>
        <translation>percettrone: {} ingressi, {} unità nascoste, {} uscite e {} pesi; attesi {}, {}, {} e {}</translation>
    </message>
    <message>
        <source>perfect</source>
        <translation>perfetta</translation>
    </message>
    <message>
        <source>period {} ms: expected 0 (each row) or 0.1 … {}</source>
        <translation>periodo {} ms: atteso 0 (ogni riga) o 0.1 … {}</translation>
    </message>
    <message>
        <source>period {} ms: expected 1 … 10000</source>
        <translation>periodo di {} ms: atteso 1 … 10000</translation>
    </message>
    <message>
        <source>period {} ms: expected more than 0</source>
        <translation>periodo {} ms: atteso più di 0</translation>
    </message>
    <message>
        <source>period {} ms: {:.0f} messages in {} s; expected at most {}: take a longer period or less of the trace</source>
        <translation>periodo {} ms: {:.0f} messaggi in {} s; attesi al massimo {}: prendere un periodo più lungo o meno della traccia</translation>
    </message>
    <message>
        <source>picture and target are mirror images; if the camera shows no mirrored picture, the signs of y_mm are wrong: it grows to the back, upward in the picture</source>
        <translation>immagine e bersaglio sono speculari; se la telecamera non mostra un'immagine specchiata, i segni di y_mm sono sbagliati: cresce verso il fondo, verso l'alto nell'immagine</translation>
    </message>
    <message>
        <source>picture {} cannot be coded</source>
        <translation>l'immagine {} non può essere codificata</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>immagini</translation>
    </message>
    <message>
        <source>pilot, left hand</source>
        <translation>pilota, mano sinistra</translation>
    </message>
    <message>
        <source>ply header, line {} "{}": expected format 1.0, then elements vertex (x, y, z, each float or double) and face (a list vertex_indices, uchar int) with the types of their properties</source>
        <translation>intestazione ply, riga {} "{}": atteso format 1.0, poi gli elementi vertex (x, y, z, ciascuno float o double) e face (una list vertex_indices, uchar int) con i tipi delle loro proprietà</translation>
    </message>
    <message>
        <source>png: the picture could not be made</source>
        <translation>png: l'immagine non è stata prodotta</translation>
    </message>
    <message>
        <source>polynomial of degree 2</source>
        <translation>polinomio di grado 2</translation>
    </message>
    <message>
        <source>polynomial of degree 3</source>
        <translation>polinomio di grado 3</translation>
    </message>
    <message>
        <source>polynomial of degree 4</source>
        <translation>polinomio di grado 4</translation>
    </message>
    <message>
        <source>polynomial of degree 5</source>
        <translation>polinomio di grado 5</translation>
    </message>
    <message>
        <source>polynomial: c0 + c1 v + ..., constant first; inverse: c0/(v + c1) + c2.</source>
        <translation>polynomial: c0 + c1 v + ..., prima la costante; inverse: c0/(v + c1) + c2.</translation>
    </message>
    <message>
        <source>position</source>
        <translation>posizione</translation>
    </message>
    <message>
        <source>position duties {} %, expected -100 to 100</source>
        <translation>duty di posizione {} %, attesi da -100 a 100</translation>
    </message>
    <message>
        <source>position duty {}</source>
        <translation>duty di posizione {}</translation>
    </message>
    <message>
        <source>precision {} mm: expected more than 0</source>
        <translation>precisione {} mm: attesa più di 0</translation>
    </message>
    <message>
        <source>predictor "{}": expected one of {}</source>
        <translation>predittore "{}": atteso uno di {}</translation>
    </message>
    <message>
        <source>predictor "{}": expected one of {}, {}</source>
        <translation>predittore "{}": atteso uno di {}, {}</translation>
    </message>
    <message>
        <source>preparing %1 triangles…</source>
        <translation>preparazione di %1 triangoli…</translation>
    </message>
    <message>
        <source>preset %1</source>
        <translation>preimpostazione %1</translation>
    </message>
    <message>
        <source>preset '{}': expected a name of 1 to {} letters, digits, spaces, '-' or '_', with no space at its ends</source>
        <translation>preimpostazione '{}': atteso un nome da 1 a {} lettere, cifre, spazi, '-' o '_', senza spazi ai margini</translation>
    </message>
    <message>
        <source>preset '{}': there is one of this name; delete it first or choose another name</source>
        <translation>preimpostazione '{}': ce n'è una con questo nome; eliminarla prima o scegliere un altro nome</translation>
    </message>
    <message>
        <source>press slower, and hold each depth</source>
        <translation>premere più piano, e tenere ogni profondità</translation>
    </message>
    <message>
        <source>pressed down by</source>
        <translation>premuto di</translation>
    </message>
    <message>
        <source>probe: {} is {}; expected a number above 0</source>
        <translation>sonda: {} è {}; atteso un numero maggiore di 0</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>proposto</translation>
    </message>
    <message>
        <source>put in</source>
        <translation>messa</translation>
    </message>
    <message>
        <source>quick stop active</source>
        <translation>arresto rapido in corso</translation>
    </message>
    <message>
        <source>radius share</source>
        <translation>quota del raggio</translation>
    </message>
    <message>
        <source>radius share %1 ± %2</source>
        <translation>quota del raggio %1 ± %2</translation>
    </message>
    <message>
        <source>rate = {} Hz: expected more than 0</source>
        <translation>frequenza = {} Hz: attesa più di 0</translation>
    </message>
    <message>
        <source>rate = {} Hz: expected {} … {}</source>
        <translation>frequenza = {} Hz: attesi {} … {}</translation>
    </message>
    <message>
        <source>reach_mm of a soft body is {}; expected more than 0</source>
        <translation>reach_mm di un corpo morbido è {}; atteso più di 0</translation>
    </message>
    <message>
        <source>reachable</source>
        <translation>raggiungibile</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>lettura</translation>
    </message>
    <message>
        <source>reading not a number</source>
        <translation>lettura che non è un numero</translation>
    </message>
    <message>
        <source>readings too unsteady</source>
        <translation>letture troppo instabili</translation>
    </message>
    <message>
        <source>ready to switch on</source>
        <translation>pronto ad accendersi</translation>
    </message>
    <message>
        <source>recorded at {} Hz: {} Hz is less than 1/{} of that</source>
        <translation>registrato a {} Hz: {} Hz è meno di 1/{} di quello</translation>
    </message>
    <message>
        <source>recorder crashed</source>
        <translation>registratore interrotto</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>registrazione</translation>
    </message>
    <message>
        <source>recording of {} Hz at {} mm/s: no band of it can stand in a surface model</source>
        <translation>registrazione di {} Hz a {} mm/s: nessuna sua banda può stare in un modello di superficie</translation>
    </message>
    <message>
        <source>recording of {} samples: expected at least {}</source>
        <translation>registrazione di {} campioni: attesi almeno {}</translation>
    </message>
    <message>
        <source>recording {}, {:.1f} s, played once; motors are not driven</source>
        <translation>registrazione {}, {:.1f} s, riprodotta una volta; i motori non sono comandati</translation>
    </message>
    <message>
        <source>recording {}, {} pictures, played once</source>
        <translation>registrazione {}, {} immagini, riprodotta una volta</translation>
    </message>
    <message>
        <source>recording {}: the count {} is beyond all measure</source>
        <translation>registrazione {}: il conteggio {} è fuori da ogni misura</translation>
    </message>
    <message>
        <source>recording's id '{}': expected 1 to 64 letters, digits or dashes</source>
        <translation>id della registrazione '{}': attesi da 1 a 64 lettere, cifre o trattini</translation>
    </message>
    <message>
        <source>recording: no file name</source>
        <translation>registrazione: nessun nome di file</translation>
    </message>
    <message>
        <source>recording: no vibration above {} Hz in it</source>
        <translation>registrazione: nessuna vibrazione oltre {} Hz</translation>
    </message>
    <message>
        <source>recording: sample {} is {} g: expected {} … {}</source>
        <translation>registrazione: il campione {} è {} g: attesi {} … {}</translation>
    </message>
    <message>
        <source>recording: {} g around {} Hz: expected at most {} g</source>
        <translation>registrazione: {} g intorno a {} Hz: atteso al massimo {} g</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>riferimento</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>rifiutato: %1</translation>
    </message>
    <message>
        <source>region {:.0f} × {:.0f} px</source>
        <translation>regione {:.0f} × {:.0f} px</translation>
    </message>
    <message>
        <source>relay: the called side's address {} has no port</source>
        <translation>relè: l'indirizzo {} del lato chiamato non ha porta</translation>
    </message>
    <message>
        <source>relay: {} stands on both sides; expected two addresses</source>
        <translation>relè: {} sta da entrambe le parti; attesi due indirizzi</translation>
    </message>
    <message>
        <source>renaming of preset %1</source>
        <translation>cambio di nome della preimpostazione %1</translation>
    </message>
    <message>
        <source>repeatability %1</source>
        <translation>ripetibilità %1</translation>
    </message>
    <message>
        <source>repeated</source>
        <translation>ripetuto</translation>
    </message>
    <message>
        <source>repeated pictures</source>
        <translation>immagini ripetute</translation>
    </message>
    <message>
        <source>resonance</source>
        <translation>risonanza</translation>
    </message>
    <message>
        <source>resume</source>
        <translation>riprendere</translation>
    </message>
    <message>
        <source>rigidity_N_per_mm of a soft body is {}; expected more than 0</source>
        <translation>rigidity_N_per_mm di un corpo morbido è {}; atteso più di 0</translation>
    </message>
    <message>
        <source>rings, then settles</source>
        <translation>oscilla, poi si assesta</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>robot</translation>
    </message>
    <message>
        <source>robot %1</source>
        <translation>robot %1</translation>
    </message>
    <message>
        <source>robot '{}': FYD Link needs a key file; fyd link keygen makes one</source>
        <translation>robot '{}': FYD Link ha bisogno di un file della chiave; fyd link keygen ne crea uno</translation>
    </message>
    <message>
        <source>robot '{}': expected simulated, scene:FILE, none, link:HOST:PORT or classic:HOST:PORT</source>
        <translation>robot '{}': atteso simulated, scene:FILE, none, link:HOST:PORT o classic:HOST:PORT</translation>
    </message>
    <message>
        <source>robot '{}': takes no key file; only link:HOST:PORT does</source>
        <translation>robot '{}': non prende un file della chiave; solo link:HOST:PORT lo prende</translation>
    </message>
    <message>
        <source>robot end: known stiffness {} N/mm; expected 0 or more</source>
        <translation>lato robot: rigidezza nota {} N/mm; atteso 0 o più</translation>
    </message>
    <message>
        <source>robot end: the touchpad's address {} has no port to call</source>
        <translation>lato robot: l'indirizzo {} del touchpad non ha una porta da chiamare</translation>
    </message>
    <message>
        <source>robot end: {}</source>
        <translation>lato robot: {}</translation>
    </message>
    <message>
        <source>robot end: {} cannot call {}: both must be IPv4 or both IPv6</source>
        <translation>lato robot: {} non può chiamare {}: entrambi devono essere IPv4 o entrambi IPv6</translation>
    </message>
    <message>
        <source>robot end: {} states a second; expected 1 to 10000</source>
        <translation>lato robot: {} stati al secondo; attesi da 1 a 10000</translation>
    </message>
    <message>
        <source>robot target ({}, {}, {}) mm: expected three finite numbers</source>
        <translation>obiettivo del robot ({}, {}, {}) mm: attesi tre numeri finiti</translation>
    </message>
    <message>
        <source>row {}: position {} mm; expected one within ±{}, or NaN in a gap</source>
        <translation>riga {}: posizione {} mm; attesa una entro ±{}, o NaN in una lacuna</translation>
    </message>
    <message>
        <source>row {}: time {} s; expected one later than the row before</source>
        <translation>riga {}: tempo {} s; atteso uno dopo quello della riga prima</translation>
    </message>
    <message>
        <source>row {}: {} events</source>
        <translation>riga {}: {} eventi</translation>
    </message>
    <message>
        <source>rows at its end that no sound commit proves: {}</source>
        <translation>righe alla sua fine che nessuna conferma integra prova: {}</translation>
    </message>
    <message>
        <source>rows {}+{} of {}</source>
        <translation>righe {}+{} di {}</translation>
    </message>
    <message>
        <source>running</source>
        <translation>in corso</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>saturata</translation>
    </message>
    <message>
        <source>saved %1</source>
        <translation>salvato %1</translation>
    </message>
    <message>
        <source>saved values are felt now; go back to the current ones to change any</source>
        <translation>ora si sentono i valori salvati; tornare a quelli attuali per cambiarne uno</translation>
    </message>
    <message>
        <source>saving of preset %1</source>
        <translation>salvataggio della preimpostazione %1</translation>
    </message>
    <message>
        <source>scene '{}': the robot is a scene already, '{}'</source>
        <translation>scena '{}': il robot è già una scena, '{}'</translation>
    </message>
    <message>
        <source>scene {}</source>
        <translation>scena {}</translation>
    </message>
    <message>
        <source>scene: {} meshes; expected {}, as there are bodies</source>
        <translation>scena: {} mesh; attese {}, quanti sono i corpi</translation>
    </message>
    <message>
        <source>scene: {} models; expected {}, as there are bodies</source>
        <translation>scena: {} modelli; attesi {}, quanti sono i corpi</translation>
    </message>
    <message>
        <source>scene: {} textures; expected {}, as there are bodies</source>
        <translation>scena: {} superfici; attese {}, quanti sono i corpi</translation>
    </message>
    <message>
        <source>search text: {}</source>
        <translation>testo cercato: {}</translation>
    </message>
    <message>
        <source>search text: {} bytes, at most {} words are looked for</source>
        <translation>testo cercato: {} byte, si cercano al più {} parole</translation>
    </message>
    <message>
        <source>second</source>
        <translation>secondo</translation>
    </message>
    <message>
        <source>second scale</source>
        <translation>scala del secondo</translation>
    </message>
    <message>
        <source>second zero</source>
        <translation>zero del secondo</translation>
    </message>
    <message>
        <source>send info and pause</source>
        <translation>inviare informazioni e pausa</translation>
    </message>
    <message>
        <source>sensing.ir_offset_mm has {} values for {} sensors: tare first</source>
        <translation>sensing.ir_offset_mm ha {} valori per {} sensori: fare prima la tara</translation>
    </message>
    <message>
        <source>sensor {} with {} codes and {} distances; expected 1 to {} and as many of each</source>
        <translation>sensore {} con {} codici e {} distanze; atteso da 1 a {} e altrettanti gli uni e le altre</translation>
    </message>
    <message>
        <source>sensor: expected 0 to 8</source>
        <translation>sensor: atteso da 0 a 8</translation>
    </message>
    <message>
        <source>sensors contradict each other</source>
        <translation>i sensori si contraddicono</translation>
    </message>
    <message>
        <source>sensors: nothing received yet</source>
        <translation>sensori: ancora nulla ricevuto</translation>
    </message>
    <message>
        <source>sent, not yet confirmed</source>
        <translation>inviato, non ancora confermato</translation>
    </message>
    <message>
        <source>serial number</source>
        <translation>numero di serie</translation>
    </message>
    <message>
        <source>session '': an empty id names no session</source>
        <translation>sessione '': un identificativo vuoto non indica alcuna sessione</translation>
    </message>
    <message>
        <source>session '{}': not in {}</source>
        <translation>sessione '{}': non in {}</translation>
    </message>
    <message>
        <source>session '{}': several begin so; give more digits</source>
        <translation>sessione '{}': più d'una comincia così; dare più cifre</translation>
    </message>
    <message>
        <source>session time, s</source>
        <translation>tempo sessione, s</translation>
    </message>
    <message>
        <source>set to {:.0f} %</source>
        <translation>impostato a {:.0f} %</translation>
    </message>
    <message>
        <source>settles</source>
        <translation>si assesta</translation>
    </message>
    <message>
        <source>several</source>
        <translation>diversi</translation>
    </message>
    <message>
        <source>silent</source>
        <translation>tace</translation>
    </message>
    <message>
        <source>silent; is it plugged in and switched on?</source>
        <translation>tace; è collegato e acceso?</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simulato</translation>
    </message>
    <message>
        <source>simulated camera</source>
        <translation>telecamera simulata</translation>
    </message>
    <message>
        <source>simulated camera, 320 × 240 at {:.0f} fps</source>
        <translation>telecamera simulata, 320 × 240 a {:.0f} fps</translation>
    </message>
    <message>
        <source>simulated robot on {}</source>
        <translation>robot simulato su {}</translation>
    </message>
    <message>
        <source>simulated touchpad, seed {}</source>
        <translation>touchpad simulato, seme {}</translation>
    </message>
    <message>
        <source>simulated touchpad: nothing to serve it through</source>
        <translation>touchpad simulato: nulla attraverso cui offrirlo</translation>
    </message>
    <message>
        <source>skipped</source>
        <translation>saltata</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>pendenza</translation>
    </message>
    <message>
        <source>slope fits force against indentation with uncertainty; thesis is the bare ratio.</source>
        <translation>slope adatta la forza all'indentazione con incertezza; thesis è il semplice rapporto.</translation>
    </message>
    <message>
        <source>slope per angle, monotone law</source>
        <translation>pendenza per angolo, legge monotona</translation>
    </message>
    <message>
        <source>smoothing of {} ms: expected 0 to 1000</source>
        <translation>livellamento di {} ms: atteso da 0 a 1000</translation>
    </message>
    <message>
        <source>smoothing {} ms: expected 0 … 1000</source>
        <translation>livellamento di {} ms: atteso 0 … 1000</translation>
    </message>
    <message>
        <source>solid</source>
        <translation>continua</translation>
    </message>
    <message>
        <source>speed = {} mm/s: expected {} … {}, or none when it is unknown</source>
        <translation>speed = {} mm/s: atteso {} … {}, o nulla se è ignota</translation>
    </message>
    <message>
        <source>speed limit {} mm/s: expected 1 to 1000</source>
        <translation>limite di velocità {} mm/s: atteso da 1 a 1000</translation>
    </message>
    <message>
        <source>spread x %1, y %2, z %3</source>
        <translation>dispersione x %1, y %2, z %3</translation>
    </message>
    <message>
        <source>spread_mm of a soft body is {}; expected 0 or more</source>
        <translation>spread_mm di un corpo morbido è {}; atteso 0 o più</translation>
    </message>
    <message>
        <source>stale</source>
        <translation>scaduto</translation>
    </message>
    <message>
        <source>stale answers</source>
        <translation>risposte scadute</translation>
    </message>
    <message>
        <source>start it</source>
        <translation>avviarla</translation>
    </message>
    <message>
        <source>started_utc: {}</source>
        <translation>started_utc: {}</translation>
    </message>
    <message>
        <source>state of {} bytes: damaged</source>
        <translation>stato di {} byte: danneggiato</translation>
    </message>
    <message>
        <source>state of {} bytes: expected at least {}</source>
        <translation>stato di {} byte: attesi almeno {}</translation>
    </message>
    <message>
        <source>state of {} bytes: {}</source>
        <translation>stato di {} byte: {}</translation>
    </message>
    <message>
        <source>state saved with another surface or scene; expected the same</source>
        <translation>stato salvato con un’altra superficie o un’altra scena; attesa la stessa</translation>
    </message>
    <message>
        <source>state with {} bytes of content: expected {}</source>
        <translation>stato con {} byte di contenuto: attesi {}</translation>
    </message>
    <message>
        <source>status word</source>
        <translation>parola di stato</translation>
    </message>
    <message>
        <source>stiffness falls from {:.3f} N/mm at {:.3g} deg to {:.3f} at {:.3g} deg, though stretching stiffens the cloth: press at both angles again, and look whether the cloth slips</source>
        <translation>la rigidezza scende da {:.3f} N/mm a {:.3g} gradi a {:.3f} a {:.3g} gradi, benché la tensione irrigidisca il tessuto: premere di nuovo a entrambi gli angoli e guardare se il tessuto scivola</translation>
    </message>
    <message>
        <source>stiffness known to about %1 %</source>
        <translation>rigidezza nota a circa %1 %</translation>
    </message>
    <message>
        <source>still being recorded</source>
        <translation>ancora in registrazione</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>fermato</translation>
    </message>
    <message>
        <source>stream</source>
        <translation>flusso</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>tensione</translation>
    </message>
    <message>
        <source>stretch {:g}°: beyond control.motor_limit_deg = {:.0f}</source>
        <translation>tensione {:g}°: oltre control.motor_limit_deg = {:.0f}</translation>
    </message>
    <message>
        <source>subject "{}": expected a code of letters, digits, - and _ such as S07, at most {} characters; never a name</source>
        <translation>soggetto "{}": atteso un codice di lettere, cifre, - e _ come S07, al più {} caratteri; mai un nome</translation>
    </message>
    <message>
        <source>subject %1</source>
        <translation>soggetto %1</translation>
    </message>
    <message>
        <source>supply undervoltage</source>
        <translation>sottotensione dell'alimentazione</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>corsa</translation>
    </message>
    <message>
        <source>switch-on disabled</source>
        <translation>accensione inibita</translation>
    </message>
    <message>
        <source>switched off by itself</source>
        <translation>spenta da sé</translation>
    </message>
    <message>
        <source>switched on</source>
        <translation>acceso</translation>
    </message>
    <message>
        <source>tag '{}': empty</source>
        <translation>etichetta '{}': vuota</translation>
    </message>
    <message>
        <source>tags: {}, at most {} are catalogued</source>
        <translation>etichette: {}, se ne catalogano al più {}</translation>
    </message>
    <message>
        <source>take points first</source>
        <translation>prendere prima i punti</translation>
    </message>
    <message>
        <source>take the hand away and start again</source>
        <translation>allontanare la mano e ricominciare</translation>
    </message>
    <message>
        <source>take the weights off again one by one to see drift and hysteresis</source>
        <translation>togliere di nuovo i pesi uno a uno per vedere deriva e isteresi</translation>
    </message>
    <message>
        <source>taken</source>
        <translation>preso</translation>
    </message>
    <message>
        <source>taken with another curve: take it again</source>
        <translation>presi con un'altra curva: prenderli di nuovo</translation>
    </message>
    <message>
        <source>target</source>
        <translation>obiettivo</translation>
    </message>
    <message>
        <source>target limited</source>
        <translation>obiettivo limitato</translation>
    </message>
    <message>
        <source>temperature {}</source>
        <translation>temperatura {}</translation>
    </message>
    <message>
        <source>tension ratio</source>
        <translation>rapporto di tensione</translation>
    </message>
    <message>
        <source>tension ratio %1 ± %2</source>
        <translation>rapporto di tensione %1 ± %2</translation>
    </message>
    <message>
        <source>the axes stand {:.1f} deg from a right angle: the camera looks at the cloth aslant</source>
        <translation>gli assi distano {:.1f}° da un angolo retto: la telecamera guarda il tessuto di sbieco</translation>
    </message>
    <message>
        <source>the block changed while it was read (its two sequence numbers differ)</source>
        <translation>il blocco è cambiato durante la lettura (i suoi due numeri di sequenza differiscono)</translation>
    </message>
    <message>
        <source>the camera is %1 ± %2 below the cloth</source>
        <translation>la telecamera è %1 ± %2 sotto il tessuto</translation>
    </message>
    <message>
        <source>the camera sees a finger on the cloth: take everything off</source>
        <translation>la telecamera vede un dito sul tessuto: togliere tutto</translation>
    </message>
    <message>
        <source>the camera sees no finger: press the cloth over a distance sensor</source>
        <translation>la telecamera non vede alcun dito: premere il tessuto sopra un sensore di distanza</translation>
    </message>
    <message>
        <source>the camera sees nothing: picture black, white, of one grey, empty or in an unknown light</source>
        <translation>la telecamera non vede nulla: immagine nera, bianca, di un solo grigio, vuota o con luce sconosciuta</translation>
    </message>
    <message>
        <source>the camera sends no pictures</source>
        <translation>la telecamera non manda immagini</translation>
    </message>
    <message>
        <source>the camera shows no cloth: look under Devices whether it answers</source>
        <translation>la telecamera non mostra il tessuto: guardare in Dispositivi se risponde</translation>
    </message>
    <message>
        <source>the camera's height is known only to {:.0f} %; expected at most {:g} %</source>
        <translation>l'altezza della telecamera è nota solo al {:.0f} %; atteso al più {:g} %</translation>
    </message>
    <message>
        <source>the cloth was touched</source>
        <translation>il tessuto è stato toccato</translation>
    </message>
    <message>
        <source>the columns differ in length</source>
        <translation>le colonne hanno lunghezze diverse</translation>
    </message>
    <message>
        <source>the commits that were there have gone</source>
        <translation>le conferme che c'erano sono sparite</translation>
    </message>
    <message>
        <source>the deepest press over distance sensor {} is {:.2f} mm; expected at least {:g} mm: press deeper there</source>
        <translation>la pressione più profonda sopra il sensore di distanza {} è {:.2f} mm; attesi almeno {:g} mm: premere lì più a fondo</translation>
    </message>
    <message>
        <source>the depths do not tell the camera's height</source>
        <translation>le profondità non dicono l'altezza della telecamera</translation>
    </message>
    <message>
        <source>the disk has less than {:.0f} MB left: recording stopped</source>
        <translation>il disco ha meno di {:.0f} MB liberi: registrazione fermata</translation>
    </message>
    <message>
        <source>the disk: one commit changes more than the journal holds</source>
        <translation>il disco: una conferma cambia più di quanto il giornale contenga</translation>
    </message>
    <message>
        <source>the disk: {}</source>
        <translation>il disco: {}</translation>
    </message>
    <message>
        <source>the distance sensors are silent</source>
        <translation>i sensori di distanza tacciono</translation>
    </message>
    <message>
        <source>the distance sensors repeat the codes {} although their count goes on: switch the touchpad off and on</source>
        <translation>i sensori di distanza ripetono i codici {} benché il loro conteggio prosegua: spegnere e riaccendere il touchpad</translation>
    </message>
    <message>
        <source>the distances span only {:.3g} mm, {:g} to {:g}; expected at least {:g}: add points between {:g} and {:g} mm</source>
        <translation>le distanze coprono solo {:.3g} mm, da {:g} a {:g}; ne servono almeno {:g}: aggiungere punti tra {:g} e {:g} mm</translation>
    </message>
    <message>
        <source>the finger is {:.1f} mm beside distance sensor {}, at most {:g} mm count: move it to {:.0f}, {:.0f} mm</source>
        <translation>il dito è {:.1f} mm a lato del sensore di distanza {}, contano al più {:g} mm: spostarlo a {:.0f}, {:.0f} mm</translation>
    </message>
    <message>
        <source>the haptic loop stood still for more than 20 ms</source>
        <translation>il ciclo aptico è rimasto fermo più di 20 ms</translation>
    </message>
    <message>
        <source>the indentation was never proven on this cloth (fyd calibrate cloth): an indentation from the distance sensors can be wrong by 15 % and more, and the stiffness with it</source>
        <translation>l'indentazione non è mai stata provata su questo tessuto (fyd calibrate cloth): un'indentazione dai sensori di distanza può essere sbagliata del 15 % e più, e con essa la rigidezza</translation>
    </message>
    <message>
        <source>the inverse form finds no curve through these points</source>
        <translation>la forma inversa non trova una curva per questi punti</translation>
    </message>
    <message>
        <source>the last %1 s</source>
        <translation>gli ultimi %1 s</translation>
    </message>
    <message>
        <source>the law is rising; beyond its ends the controller stays at them</source>
        <translation>la legge è crescente; oltre i suoi estremi il controllo si ferma lì</translation>
    </message>
    <message>
        <source>the load cell is silent</source>
        <translation>la cella di carico tace</translation>
    </message>
    <message>
        <source>the load cell repeats {} mV/V although its count goes on: switch the touchpad off and on</source>
        <translation>la cella di carico ripete {} mV/V benché il suo conteggio prosegua: spegnere e riaccendere il touchpad</translation>
    </message>
    <message>
        <source>the load cell's value is outside its span</source>
        <translation>il valore della cella di carico è fuori dal suo campo</translation>
    </message>
    <message>
        <source>the mesh has no triangle that has an area</source>
        <translation>la mesh non ha alcun triangolo con un'area</translation>
    </message>
    <message>
        <source>the millimetres lie on one line though the pixels do not: check the columns x_mm and y_mm</source>
        <translation>i millimetri stanno su una retta benché i pixel non vi stiano: controllare le colonne x_mm e y_mm</translation>
    </message>
    <message>
        <source>the motion goes beyond control.motor_limit_deg</source>
        <translation>il movimento va oltre control.motor_limit_deg</translation>
    </message>
    <message>
        <source>the motors are in use: stop the session first</source>
        <translation>i motori sono in uso: fermare prima la sessione</translation>
    </message>
    <message>
        <source>the motors are silent</source>
        <translation>i motori tacciono</translation>
    </message>
    <message>
        <source>the motors do not answer</source>
        <translation>i motori non rispondono</translation>
    </message>
    <message>
        <source>the other end does not say that it holds this scene</source>
        <translation>l’altra estremità non dice di avere questa scena</translation>
    </message>
    <message>
        <source>the other end holds a scene, this one none</source>
        <translation>l’altra estremità ha una scena, questa nessuna</translation>
    </message>
    <message>
        <source>the others contradict point %1</source>
        <translation>gli altri contraddicono il punto %1</translation>
    </message>
    <message>
        <source>the outliers are kept in the fit; measure them again</source>
        <translation>i valori anomali restano nell'adattamento; misurarli di nuovo</translation>
    </message>
    <message>
        <source>the picture has one grey value only: check the camera and the light</source>
        <translation>l'immagine ha un solo valore di grigio: controllare la telecamera e la luce</translation>
    </message>
    <message>
        <source>the picture is frozen: the camera sends the same one again and again; unplug it and plug it in again</source>
        <translation>l'immagine è congelata: la telecamera manda sempre la stessa; scollegarla e ricollegarla</translation>
    </message>
    <message>
        <source>the ply header does not end</source>
        <translation>l'intestazione ply non finisce</translation>
    </message>
    <message>
        <source>the points at {:.3g} deg cannot be predicted from the others: press there again, to different depths</source>
        <translation>i punti a {:.3g} gradi non si possono prevedere dagli altri: premere ancora lì, a profondità diverse</translation>
    </message>
    <message>
        <source>the points do not tell the unknowns apart (condition number {:.3g})</source>
        <translation>i punti non distinguono le incognite (numero di condizionamento {:.3g})</translation>
    </message>
    <message>
        <source>the points lie on one line in the picture: add points off that line, at the corners of the cloth</source>
        <translation>i punti stanno su una retta nell'immagine: aggiungere punti fuori da quella retta, agli angoli del tessuto</translation>
    </message>
    <message>
        <source>the presses over distance sensor {} are all about equally deep ({:.2f} to {:.2f} mm); expected {:g} times as deep at the deepest: press there at two depths</source>
        <translation>le pressioni sopra il sensore di distanza {} sono tutte circa ugualmente profonde (da {:.2f} a {:.2f} mm); attesa la più profonda {:g} volte tanto: premere lì a due profondità</translation>
    </message>
    <message>
        <source>the profile names no distance sensor: see sensing.ir_x_mm</source>
        <translation>il profilo non nomina alcun sensore di distanza: vedere sensing.ir_x_mm</translation>
    </message>
    <message>
        <source>the profile's values are another touchpad's: the defaults are used</source>
        <translation>i valori del profilo sono di un altro touchpad: si usano quelli predefiniti</translation>
    </message>
    <message>
        <source>the radius share {:.2f} is known only to {:.0f} % and the tension ratio {:.2f} to {:.0f} %; expected at most {:g} % and {:g} %: hold each press longer, so that its mean has less noise, and press deeper</source>
        <translation>la quota del raggio {:.2f} è nota solo al {:.0f} % e il rapporto di tensione {:.2f} al {:.0f} %; atteso al massimo {:g} % e {:g} %: tenere più a lungo ogni pressione, perché la sua media abbia meno rumore, e premere più a fondo</translation>
    </message>
    <message>
        <source>the reading drifts by {:.3f} N over the measurement: let the bridge warm up</source>
        <translation>la lettura deriva di {:.3f} N durante la misura: lasciar scaldare il ponte</translation>
    </message>
    <message>
        <source>the recorder is not running</source>
        <translation>il registratore non è attivo</translation>
    </message>
    <message>
        <source>the recording holds no state of the step to start from: steps had been lost before it began; it can be looked at, not replayed</source>
        <translation>la registrazione non contiene uno stato del passo da cui partire: dei passi erano andati persi prima che iniziasse; si può guardare, non rieseguire</translation>
    </message>
    <message>
        <source>the recording holds no step</source>
        <translation>la registrazione non contiene passi</translation>
    </message>
    <message>
        <source>the recording is closed</source>
        <translation>la registrazione è chiusa</translation>
    </message>
    <message>
        <source>the region is {} × {} px; expected at least {} px each way: drag a larger one</source>
        <translation>la regione è di {} × {} px; attesi almeno {} px per lato: trascinarne una più grande</translation>
    </message>
    <message>
        <source>the robot has said goodbye</source>
        <translation>il robot si è congedato</translation>
    </message>
    <message>
        <source>the robot is silent</source>
        <translation>il robot tace</translation>
    </message>
    <message>
        <source>the robot sends no acceleration: look at the link's panel</source>
        <translation>il robot non manda accelerazioni: vedere il pannello del collegamento</translation>
    </message>
    <message>
        <source>the robot's end has taken rest away before it sends: whether 1 g is 1 g is not seen here</source>
        <translation>il lato robot toglie il riposo prima di inviare: qui non si vede se 1 g è 1 g</translation>
    </message>
    <message>
        <source>the robot's stiffness is not a number</source>
        <translation>la rigidezza del robot non è un numero</translation>
    </message>
    <message>
        <source>the session is closed</source>
        <translation>la sessione è chiusa</translation>
    </message>
    <message>
        <source>the simulated touchpad</source>
        <translation>il touchpad simulato</translation>
    </message>
    <message>
        <source>the station uses %1 of its own accord</source>
        <translation>la stazione usa %1 di propria iniziativa</translation>
    </message>
    <message>
        <source>the status word 0x{:04X} names no state</source>
        <translation>la parola di stato 0x{:04X} non indica uno stato</translation>
    </message>
    <message>
        <source>the step's input is farther away than 1e9 mm</source>
        <translation>un dato del passo è più lontano di 1e9 mm</translation>
    </message>
    <message>
        <source>the step's input is not a number</source>
        <translation>un dato del passo non è un numero</translation>
    </message>
    <message>
        <source>the stiffness does not change with the angle: check that the motors stretch the cloth</source>
        <translation>la rigidezza non cambia con l'angolo: controllare che i motori tendano il tessuto</translation>
    </message>
    <message>
        <source>the stretch is not known: look under Devices whether the motors answer</source>
        <translation>la tensione non è nota: vedere in Dispositivi se i motori rispondono</translation>
    </message>
    <message>
        <source>the stretch lies outside control.travel_minimum_deg and control.travel_maximum_deg</source>
        <translation>la tensione è fuori da control.travel_minimum_deg e control.travel_maximum_deg</translation>
    </message>
    <message>
        <source>the temporary columns cannot be mapped: {}</source>
        <translation>le colonne temporanee non si possono mappare: {}</translation>
    </message>
    <message>
        <source>the temporary columns cannot be written: {}</source>
        <translation>le colonne temporanee non si possono scrivere: {}</translation>
    </message>
    <message>
        <source>the three axes differ in length</source>
        <translation>i tre assi hanno lunghezza diversa</translation>
    </message>
    <message>
        <source>the time step is not between 1e-6 s and 1 s</source>
        <translation>la durata del passo non è tra 1e-6 s e 1 s</translation>
    </message>
    <message>
        <source>the touchpad answers, but its clock or its count of value sets stands still: switch it off and on</source>
        <translation>il touchpad risponde, ma il suo orologio o il suo conteggio dei gruppi di valori è fermo: spegnerlo e riaccenderlo</translation>
    </message>
    <message>
        <source>the touchpad closed the connection</source>
        <translation>il touchpad ha chiuso la connessione</translation>
    </message>
    <message>
        <source>the touchpad does not answer the call</source>
        <translation>il touchpad non risponde alla chiamata</translation>
    </message>
    <message>
        <source>the touchpad does not obey what is written to it (bit 9 of its status word)</source>
        <translation>il touchpad non obbedisce a ciò che gli viene scritto (bit 9 della sua parola di stato)</translation>
    </message>
    <message>
        <source>the touchpad renders, motors on</source>
        <translation>il touchpad rende, motori accesi</translation>
    </message>
    <message>
        <source>the touchpad restarted</source>
        <translation>il touchpad si è riavviato</translation>
    </message>
    <message>
        <source>the touchpad was lost while its motors were being switched on</source>
        <translation>il touchpad è stato perso mentre i suoi motori si accendevano</translation>
    </message>
    <message>
        <source>the touchpad with serial number {}</source>
        <translation>il touchpad con numero di serie {}</translation>
    </message>
    <message>
        <source>the touchpad {}</source>
        <translation>il touchpad {}</translation>
    </message>
    <message>
        <source>the touchpad's motors are in the state {}</source>
        <translation>i motori del touchpad sono nello stato {}</translation>
    </message>
    <message>
        <source>the two ends hold different scenes: open copies of one file</source>
        <translation>le due estremità hanno scene diverse: aprire copie dello stesso file</translation>
    </message>
    <message>
        <source>the value does not follow the weight: check the cell's cable</source>
        <translation>il valore non segue il peso: controllare il cavo della cella</translation>
    </message>
    <message>
        <source>the value stays at {:.6g} mV/V whatever the weight: check the cell's cable and the bridge's channel</source>
        <translation>il valore resta a {:.6g} mV/V qualunque sia il peso: controllare il cavo della cella e il canale del ponte</translation>
    </message>
    <message>
        <source>the values are too large to compute with</source>
        <translation>i valori sono troppo grandi per i calcoli</translation>
    </message>
    <message>
        <source>the values do not fit this session</source>
        <translation>i valori non sono adatti a questa sessione</translation>
    </message>
    <message>
        <source>the weights span only {:.3g} N; expected at least {:g}: {}</source>
        <translation>i pesi coprono solo {:.3g} N; ne servono almeno {:g}: {}</translation>
    </message>
    <message>
        <source>the window did not answer for half a second</source>
        <translation>la finestra non ha risposto per mezzo secondo</translation>
    </message>
    <message>
        <source>the {} bytes are no whole {} file</source>
        <translation>i {} byte non sono un file {} intero</translation>
    </message>
    <message>
        <source>there is no picture: look under Devices whether the camera answers</source>
        <translation>non c'è immagine: guardare in Dispositivi se la telecamera risponde</translation>
    </message>
    <message>
        <source>there is no triangle in the {} bytes of this {} file</source>
        <translation>non c'è alcun triangolo nei {} byte di questo file {}</translation>
    </message>
    <message>
        <source>these {} bytes are not a state of arithmetic 1</source>
        <translation>questi {} byte non sono uno stato dell'aritmetica 1</translation>
    </message>
    <message>
        <source>these {} bytes are not the state of a pipeline</source>
        <translation>questi {} byte non sono lo stato di una pipeline</translation>
    </message>
    <message>
        <source>thesis polynomial, scaled and shifted</source>
        <translation>polinomio della tesi, scalato e traslato</translation>
    </message>
    <message>
        <source>this camera has none, or refuses the value</source>
        <translation>questa telecamera non ne ha, o rifiuta il valore</translation>
    </message>
    <message>
        <source>this computer was late: {:.1f} % of the haptic cycles of that second were missed, longest gap {:.0f} ms; close other programs</source>
        <translation>questo computer era in ritardo: {:.1f} % dei cicli aptici di quel secondo mancati, intervallo più lungo {:.0f} ms; chiudere altri programmi</translation>
    </message>
    <message>
        <source>this part was never calibrated: accept a calibration first</source>
        <translation>questa parte non è mai stata calibrata: accettare prima una calibrazione</translation>
    </message>
    <message>
        <source>this source has none</source>
        <translation>questa sorgente non ne ha</translation>
    </message>
    <message>
        <source>time '{}': expected UTC as 2026-11-21, 2026-11-21T14:05 or 2026-11-21T14:05:09.250Z</source>
        <translation>tempo '{}': atteso UTC come 2026-11-21, 2026-11-21T14:05 o 2026-11-21T14:05:09.250Z</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>tempo (s)</translation>
    </message>
    <message>
        <source>time limit reached</source>
        <translation>limite di tempo raggiunto</translation>
    </message>
    <message>
        <source>time_s is no number</source>
        <translation>time_s non è un numero</translation>
    </message>
    <message>
        <source>to</source>
        <translation>a</translation>
    </message>
    <message>
        <source>tolerance of a soft body is {}; expected between 0 and 1</source>
        <translation>tolerance di un corpo morbido è {}; atteso fra 0 e 1</translation>
    </message>
    <message>
        <source>too far behind</source>
        <translation>troppo indietro</translation>
    </message>
    <message>
        <source>too few distance sensors read within their span</source>
        <translation>troppo pochi sensori di distanza leggono nel loro campo</translation>
    </message>
    <message>
        <source>too few readings beside the finger: at least two sensors must read in each press</source>
        <translation>troppo poche letture accanto al dito: almeno due sensori devono leggere in ogni pressione</translation>
    </message>
    <message>
        <source>too few readings in time</source>
        <translation>troppo poche letture in tempo</translation>
    </message>
    <message>
        <source>too few valid sensors</source>
        <translation>troppo pochi sensori validi</translation>
    </message>
    <message>
        <source>too small</source>
        <translation>troppo piccolo</translation>
    </message>
    <message>
        <source>too small to turn</source>
        <translation>troppo piccolo per girare</translation>
    </message>
    <message>
        <source>too uncertain</source>
        <translation>troppo incerto</translation>
    </message>
    <message>
        <source>tool force</source>
        <translation>forza sull'utensile</translation>
    </message>
    <message>
        <source>tool torque</source>
        <translation>coppia sull'utensile</translation>
    </message>
    <message>
        <source>torn blocks</source>
        <translation>blocchi incoerenti</translation>
    </message>
    <message>
        <source>touch %1 at %2 s</source>
        <translation>tocco %1 a %2 s</translation>
    </message>
    <message>
        <source>touch from {:.3f} to {:.3f} s: {} pictures show its finger; expected two and more</source>
        <translation>tocco da {:.3f} a {:.3f} s: {} immagini mostrano il dito; attese due o più</translation>
    </message>
    <message>
        <source>touchpad %1</source>
        <translation>touchpad %1</translation>
    </message>
    <message>
        <source>touchpad '{}': expected simulated, serial:NUMBER of 1 to {} characters, or its address</source>
        <translation>touchpad '{}': atteso simulated, serial:NUMERO da 1 a {} caratteri, o il suo indirizzo</translation>
    </message>
    <message>
        <source>touchpad at {}</source>
        <translation>touchpad su {}</translation>
    </message>
    <message>
        <source>touchpad {}</source>
        <translation>touchpad {}</translation>
    </message>
    <message>
        <source>touchpad {}, firmware {}.{}, at {}</source>
        <translation>touchpad {}, firmware {}.{}, su {}</translation>
    </message>
    <message>
        <source>trial begins</source>
        <translation>la prova comincia</translation>
    </message>
    <message>
        <source>trial ends</source>
        <translation>la prova finisce</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true o false</translation>
    </message>
    <message>
        <source>unacceptable</source>
        <translation>inaccettabile</translation>
    </message>
    <message>
        <source>under 1 min left</source>
        <translation>meno di 1 min</translation>
    </message>
    <message>
        <source>unexpected argument '{}'; --help shows the options</source>
        <translation>argomento inatteso '{}'; --help mostra le opzioni</translation>
    </message>
    <message>
        <source>unexpected kind</source>
        <translation>tipo inatteso</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>sconosciuto</translation>
    </message>
    <message>
        <source>unknown command</source>
        <translation>comando sconosciuto</translation>
    </message>
    <message>
        <source>unknown fault</source>
        <translation>guasto sconosciuto</translation>
    </message>
    <message>
        <source>unknown parameter '{}'</source>
        <translation>parametro sconosciuto '{}'</translation>
    </message>
    <message>
        <source>unknown parameter '{}'; a replay changes the step's only</source>
        <translation>parametro sconosciuto '{}'; una riesecuzione cambia solo quelli del passo</translation>
    </message>
    <message>
        <source>unknown problem</source>
        <translation>problema sconosciuto</translation>
    </message>
    <message>
        <source>unknown state, quality or strategy</source>
        <translation>stato, qualità o strategia sconosciuti</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>instabile</translation>
    </message>
    <message>
        <source>untouched</source>
        <translation>non toccato</translation>
    </message>
    <message>
        <source>up and down</source>
        <translation>in alto e in basso</translation>
    </message>
    <message>
        <source>usable</source>
        <translation>usabile</translation>
    </message>
    <message>
        <source>use DFT321</source>
        <translation>usare DFT321</translation>
    </message>
    <message>
        <source>use SoC</source>
        <translation>usare SoC</translation>
    </message>
    <message>
        <source>valid from %1 to %2</source>
        <translation>valida da %1 a %2</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valore</translation>
    </message>
    <message>
        <source>values is missing</source>
        <translation>manca values</translation>
    </message>
    <message>
        <source>vibration</source>
        <translation>vibrazione</translation>
    </message>
    <message>
        <source>vibration down</source>
        <translation>vibrazione in meno</translation>
    </message>
    <message>
        <source>vibration duties lost here</source>
        <translation>duty di vibrazione persi qui</translation>
    </message>
    <message>
        <source>vibration duties lost there</source>
        <translation>duty di vibrazione persi là</translation>
    </message>
    <message>
        <source>vibration up</source>
        <translation>vibrazione in più</translation>
    </message>
    <message>
        <source>video file</source>
        <translation>file video</translation>
    </message>
    <message>
        <source>video file '{}'</source>
        <translation>file video '{}'</translation>
    </message>
    <message>
        <source>viscosity_Ns_per_mm of a soft body is {}; expected 0 or more</source>
        <translation>viscosity_Ns_per_mm di un corpo morbido è {}; atteso 0 o più</translation>
    </message>
    <message>
        <source>wait until it is done</source>
        <translation>attendere che sia finita</translation>
    </message>
    <message>
        <source>waiting for a robot on {}</source>
        <translation>in attesa di un robot su {}</translation>
    </message>
    <message>
        <source>wall {} N/m: expected 0 (none) … 20000</source>
        <translation>parete di {} N/m: atteso 0 (nessuna) … 20000</translation>
    </message>
    <message>
        <source>wanted</source>
        <translation>voluto</translation>
    </message>
    <message>
        <source>was %1</source>
        <translation>era %1</translation>
    </message>
    <message>
        <source>was lost while its motors were on</source>
        <translation>è stata persa mentre i suoi motori erano accesi</translation>
    </message>
    <message>
        <source>was switched off because its command was not renewed in time</source>
        <translation>è stata spenta perché il suo comando non è stato rinnovato in tempo</translation>
    </message>
    <message>
        <source>what if</source>
        <translation>e se</translation>
    </message>
    <message>
        <source>whole</source>
        <translation>integra</translation>
    </message>
    <message>
        <source>width</source>
        <translation>larghezza</translation>
    </message>
    <message>
        <source>with the other edges %1</source>
        <translation>con gli altri bordi %1</translation>
    </message>
    <message>
        <source>withheld</source>
        <translation>trattenuta</translation>
    </message>
    <message>
        <source>workspace {} x {} x {} mm at {} mm: more than {} points on an axis</source>
        <translation>spazio di lavoro {} x {} x {} mm a {} mm: più di {} punti su un asse</translation>
    </message>
    <message>
        <source>workspace {} x {} x {} mm: every side must be longer than 0</source>
        <translation>spazio di lavoro {} x {} x {} mm: ogni lato deve superare 0</translation>
    </message>
    <message>
        <source>workspace ±({}, {}, {}) mm: expected three numbers above 0</source>
        <translation>spazio di lavoro ±({}, {}, {}) mm: attesi tre numeri sopra 0</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>scrittura</translation>
    </message>
    <message>
        <source>wrong button</source>
        <translation>pulsante errato</translation>
    </message>
    <message>
        <source>wrong id</source>
        <translation>id sbagliato</translation>
    </message>
    <message>
        <source>wrong key or damaged</source>
        <translation>chiave sbagliata o danneggiato</translation>
    </message>
    <message>
        <source>wrong separator</source>
        <translation>separatore errato</translation>
    </message>
    <message>
        <source>wrong sign</source>
        <translation>segno errato</translation>
    </message>
    <message>
        <source>wrong size</source>
        <translation>dimensione errata</translation>
    </message>
    <message>
        <source>wrong size field</source>
        <translation>campo della dimensione sbagliato</translation>
    </message>
    <message>
        <source>wrong start or end mark</source>
        <translation>segno di inizio o fine errato</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>x %1 mm   y %2 mm   area %3 mm²</source>
        <translation>x %1 mm   y %2 mm   area %3 mm²</translation>
    </message>
    <message>
        <source>x %1 px, y %2 px</source>
        <translation>x %1 px, y %2 px</translation>
    </message>
    <message>
        <source>x, g</source>
        <translation>x, g</translation>
    </message>
    <message>
        <source>x, mm</source>
        <translation>x, mm</translation>
    </message>
    <message>
        <source>x, px</source>
        <translation>x, px</translation>
    </message>
    <message>
        <source>x, to the right</source>
        <translation>x, verso destra</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>y, g</source>
        <translation>y, g</translation>
    </message>
    <message>
        <source>y, mm</source>
        <translation>y, mm</translation>
    </message>
    <message>
        <source>y, px</source>
        <translation>y, px</translation>
    </message>
    <message>
        <source>y, to the back</source>
        <translation>y, verso il fondo</translation>
    </message>
    <message>
        <source>your name: the record keeps it</source>
        <translation>il nome: resta nel verbale</translation>
    </message>
    <message>
        <source>z, g</source>
        <translation>z, g</translation>
    </message>
    <message>
        <source>{:.1f} % of the picture is dark; a finger takes {:.1f} to {:.0f} %: check the region of interest</source>
        <translation>il {:.1f} % dell'immagine è scuro; un dito ne occupa dal {:.1f} al {:.0f} %: controllare la regione di interesse</translation>
    </message>
    <message>
        <source>{:.3f} N/mm at {:.3g} deg is known only to {:.0f} %; expected at most {:g} %: press there more often and deeper</source>
        <translation>{:.3f} N/mm a {:.3g} gradi è noto solo al {:.0f} %; atteso al più il {:g} %: premere lì più spesso e più a fondo</translation>
    </message>
    <message>
        <source>{:.3f} mV/V is beyond the load cell's span of {:g}</source>
        <translation>{:.3f} mV/V è oltre il campo della cella di carico di {:g}</translation>
    </message>
    <message>
        <source>{} = "{}": expected {}</source>
        <translation>{} = "{}": atteso {}</translation>
    </message>
    <message>
        <source>{} = '{}': expected true or false</source>
        <translation>{} = '{}': atteso true o false</translation>
    </message>
    <message>
        <source>{} = '{}': expected {}</source>
        <translation>{} = '{}': atteso {}</translation>
    </message>
    <message>
        <source>{} = {} was refused.</source>
        <translation>{} = {} è stato rifiutato.</translation>
    </message>
    <message>
        <source>{} = {}: expected a list such as [1, 2]</source>
        <translation>{} = {}: attesa una lista come [1, 2]</translation>
    </message>
    <message>
        <source>{} = {}: expected a number from {} to {}; correct or delete the row</source>
        <translation>{} = {}: atteso un numero da {} a {}; correggere o cancellare la riga</translation>
    </message>
    <message>
        <source>{} = {}: expected {}</source>
        <translation>{} = {}: atteso {}</translation>
    </message>
    <message>
        <source>{} angles are not told apart by their stiffness and were pooled</source>
        <translation>{} angoli non si distinguono per rigidezza e sono stati uniti</translation>
    </message>
    <message>
        <source>{} axes; expected 1 to {}</source>
        <translation>{} assi; attesi da 1 a {}</translation>
    </message>
    <message>
        <source>{} by the operator. Motors are off. Arm to start again.</source>
        <translation>{} per comando dell'operatore. Motori spenti. Armare per ricominciare.</translation>
    </message>
    <message>
        <source>{} bytes are not a scene: {}</source>
        <translation>{} byte non sono una scena: {}</translation>
    </message>
    <message>
        <source>{} bytes at once</source>
        <translation>{} byte in una volta</translation>
    </message>
    <message>
        <source>{} bytes cannot be compressed ({})</source>
        <translation>{} byte non si possono comprimere ({})</translation>
    </message>
    <message>
        <source>{} cannot be drawn: {}</source>
        <translation>{} non può essere disegnato: {}</translation>
    </message>
    <message>
        <source>{} cannot change while the station runs</source>
        <translation>{} non può cambiare mentre la stazione lavora</translation>
    </message>
    <message>
        <source>{} chirps, stretches {} ° apart; expected two or more chirps, {} ° apart</source>
        <translation>{} scansioni, tensioni distanti {} °; attese due o più scansioni, distanti {} °</translation>
    </message>
    <message>
        <source>{} conditions: expected 1 … {}</source>
        <translation>{} condizioni: attese 1 … {}</translation>
    </message>
    <message>
        <source>{} different angles; expected at least {}: add presses at an angle between {:.3g} and {:.3g} deg</source>
        <translation>{} angoli diversi; ne servono almeno {}: aggiungere pressioni a un angolo fra {:.3g} e {:.3g} gradi</translation>
    </message>
    <message>
        <source>{} different distances in {} points; expected at least {}: add points between {:g} and {:g} mm (the same distance again tells only the noise)</source>
        <translation>{} distanze diverse in {} punti; ne servono almeno {}: aggiungere punti tra {:g} e {:g} mm (la stessa distanza ripetuta dice solo il rumore)</translation>
    </message>
    <message>
        <source>{} different points; expected at least {}: add points, best at the corners of the cloth</source>
        <translation>{} punti diversi; ne servono almeno {}: aggiungere punti, meglio agli angoli del tessuto</translation>
    </message>
    <message>
        <source>{} different weights in {} points; expected at least {}: {}</source>
        <translation>{} pesi diversi in {} punti; ne servono almeno {}: {}</translation>
    </message>
    <message>
        <source>{} distances; needs {}</source>
        <translation>{} distanze; ne servono {}</translation>
    </message>
    <message>
        <source>{} does not answer: {}</source>
        <translation>{} non risponde: {}</translation>
    </message>
    <message>
        <source>{} encoder turns {:.1f} % {} than commanded; expected within {:g} %: check that the motor is free, and that both are wired to the same roller</source>
        <translation>l'encoder {} gira il {:.1f} % {} di quanto comandato; atteso entro il {:g} %: controllare che il motore sia libero e che entrambi siano collegati allo stesso rullo</translation>
    </message>
    <message>
        <source>{} encoder: {}</source>
        <translation>encoder {}: {}</translation>
    </message>
    <message>
        <source>{} encoder: {} points over {:.3g} deg; expected at least 5 over {:g} deg: sweep farther</source>
        <translation>encoder {}: {} punti su {:.3g} gradi; ne servono almeno 5 su {:g} gradi: corsa più lunga</translation>
    </message>
    <message>
        <source>{} had {} values when the state was saved, here it has {}; expected the same</source>
        <translation>{} aveva {} valori quando lo stato fu salvato, qui ne ha {}; atteso lo stesso</translation>
    </message>
    <message>
        <source>{} is another kind of parameter in this program</source>
        <translation>{} è un parametro di altro tipo in questo programma</translation>
    </message>
    <message>
        <source>{} is lost for {} steps from row {} on ({})</source>
        <translation>{} è perso per {} passi dalla riga {} in poi ({})</translation>
    </message>
    <message>
        <source>{} is missing</source>
        <translation>manca {}</translation>
    </message>
    <message>
        <source>{} is not known: check its cable</source>
        <translation>{} non è noto: controllare il suo cavo</translation>
    </message>
    <message>
        <source>{} is now {:.4g}.</source>
        <translation>{} vale ora {:.4g}.</translation>
    </message>
    <message>
        <source>{} is now {}.</source>
        <translation>{} vale ora {}.</translation>
    </message>
    <message>
        <source>{} is stored, its notes are not: {}</source>
        <translation>{} è archiviato, le sue note no: {}</translation>
    </message>
    <message>
        <source>{} of {} presses are more than {:g} mm beside a sensor (up to {:.1f} mm), or over one that does not read; they tell no depth and were left out</source>
        <translation>{} di {} pressioni sono a più di {:g} mm da un sensore (fino a {:.1f} mm), o sopra uno che non legge; non dicono la profondità e sono state tralasciate</translation>
    </message>
    <message>
        <source>{} parameters change with the first step, those of the recording included; a step takes at most {}: set fewer at once</source>
        <translation>{} parametri cambiano con il primo passo, compresi quelli della registrazione; un passo ne prende al più {}: impostarne meno in una volta</translation>
    </message>
    <message>
        <source>{} points at {:.3g} deg are at least {:g} mm deep; expected at least {}: press there again, to different depths</source>
        <translation>{} punti a {:.3g} gradi sono profondi almeno {:g} mm; ne servono almeno {}: premere ancora lì, a profondità diverse</translation>
    </message>
    <message>
        <source>{} points for a {}; expected at least {}</source>
        <translation>{} punti per {}; attesi almeno {}</translation>
    </message>
    <message>
        <source>{} points for {} unknowns; expected at least as many</source>
        <translation>{} punti per {} incognite; attesi almeno altrettanti</translation>
    </message>
    <message>
        <source>{} points; at most {}: take fewer, or means</source>
        <translation>{} punti; al più {}: prenderne meno, o medie</translation>
    </message>
    <message>
        <source>{} points; the camera's height takes at least {}: at the cloth's corners, some on the untouched cloth and some pressed down</source>
        <translation>{} punti; per l'altezza della telecamera ne servono almeno {}: agli angoli del tessuto, alcuni sul tessuto non toccato e alcuni premuti in basso</translation>
    </message>
    <message>
        <source>{} positions for {} times; expected one for each</source>
        <translation>{} posizioni per {} tempi; attesa una per ciascuno</translation>
    </message>
    <message>
        <source>{} presses; at most {}: take the mean of each press</source>
        <translation>{} pressioni; al massimo {}: prendere la media di ogni pressione</translation>
    </message>
    <message>
        <source>{} repetitions: expected 1 … {}</source>
        <translation>{} ripetizioni: attese 1 … {}</translation>
    </message>
    <message>
        <source>{} rows of {} are gone before its row {} ({})</source>
        <translation>{} righe di {} mancano prima della sua riga {} ({})</translation>
    </message>
    <message>
        <source>{} rows, none of them with a position; expected one and more</source>
        <translation>{} righe, nessuna con una posizione; attesa una o più</translation>
    </message>
    <message>
        <source>{} rows; expected two and more</source>
        <translation>{} righe; attese due o più</translation>
    </message>
    <message>
        <source>{} s at {} Hz are {} samples: expected at most {}</source>
        <translation>{} s a {} Hz sono {} campioni: attesi al più {}</translation>
    </message>
    <message>
        <source>{} s from the first row to the last; expected at most {}: are the times in seconds?</source>
        <translation>{} s dalla prima riga all'ultima; attesi al massimo {}: i tempi sono in secondi?</translation>
    </message>
    <message>
        <source>{} samples; expected at least {}: wait longer</source>
        <translation>{} campioni; attesi almeno {}: attendere di più</translation>
    </message>
    <message>
        <source>{} spans only {:.3g} px; expected at least {:g}: add points farther {}</source>
        <translation>{} copre solo {:.3g} px; attesi almeno {:g}: aggiungere punti più lontani {}</translation>
    </message>
    <message>
        <source>{} steps are not committed yet</source>
        <translation>{} passi non sono ancora confermati</translation>
    </message>
    <message>
        <source>{} steps were lost</source>
        <translation>{} passi sono andati persi</translation>
    </message>
    <message>
        <source>{} triangles; at most {} can be touched</source>
        <translation>{} triangoli; se ne possono toccare al più {}</translation>
    </message>
    <message>
        <source>{} values and {} forces; expected as many of each</source>
        <translation>{} valori e {} forze; attesi altrettanti gli uni e le altre</translation>
    </message>
    <message>
        <source>{} values and {} weights for {} points</source>
        <translation>{} valori e {} pesi per {} punti</translation>
    </message>
    <message>
        <source>{} vertices; at most {} can be counted</source>
        <translation>{} vertici; se ne possono contare al più {}</translation>
    </message>
    <message>
        <source>{} was {} when the state was saved, here it is {}; expected the same</source>
        <translation>{} era {} quando lo stato fu salvato, qui è {}; atteso lo stesso</translation>
    </message>
    <message>
        <source>{} × {} pixels, expected at most {}</source>
        <translation>{} × {} pixel, attesi al più {}</translation>
    </message>
    <message>
        <source>{} × {} pixels, expected {} × {}</source>
        <translation>{} × {} pixel, attesi {} × {}</translation>
    </message>
    <message>
        <source>{}'s newest reading is {:.0f} ms old</source>
        <translation>la lettura più recente di {} ha {:.0f} ms</translation>
    </message>
    <message>
        <source>{}, from line {}: {}</source>
        <translation>{}, dalla riga {}: {}</translation>
    </message>
    <message>
        <source>{}, line {}: expected "{}"</source>
        <translation>{}, riga {}: atteso "{}"</translation>
    </message>
    <message>
        <source>{}, {} at {:.4g} fps, repeating</source>
        <translation>{}, {} a {:.4g} fps, a ripetizione</translation>
    </message>
    <message>
        <source>{}. Nothing is promised of {}.partial: another program has removed, replaced or shortened it</source>
        <translation>{}. Nulla è garantito di {}.partial: un altro programma lo ha rimosso, sostituito o accorciato</translation>
    </message>
    <message>
        <source>{}. What was written up to {:.1f} s is safe in {}.partial; make it whole with: fyd session recover</source>
        <translation>{}. Ciò che è stato scritto fino a {:.1f} s è al sicuro in {}.partial; renderlo intero con: fyd session recover</translation>
    </message>
    <message>
        <source>{}: 'body': expected tables [[body]]</source>
        <translation>{}: 'body': attese tabelle [[body]]</translation>
    </message>
    <message>
        <source>{}: '{}' is not a number; expected {}</source>
        <translation>{}: '{}' non è un numero; atteso {}</translation>
    </message>
    <message>
        <source>{}: '{}' stands outside a table; expected a table such as [control]</source>
        <translation>{}: '{}' sta fuori da una tabella; attesa una tabella come [control]</translation>
    </message>
    <message>
        <source>{}: '{}': expected a table [{}]</source>
        <translation>{}: '{}': attesa una tabella [{}]</translation>
    </message>
    <message>
        <source>{}: '{}': expected one of {}</source>
        <translation>{}: '{}': atteso uno fra {}</translation>
    </message>
    <message>
        <source>{}: [[band]]: expected either wavelength_mm or frequency_Hz</source>
        <translation>{}: [[band]]: atteso wavelength_mm oppure frequency_Hz</translation>
    </message>
    <message>
        <source>{}: [{}] without [{}]</source>
        <translation>{}: [{}] senza [{}]</translation>
    </message>
    <message>
        <source>{}: a column without a name</source>
        <translation>{}: una colonna senza nome</translation>
    </message>
    <message>
        <source>{}: a header but no rows</source>
        <translation>{}: un'intestazione ma nessuna riga</translation>
    </message>
    <message>
        <source>{}: a later program recorded {}, which a copy by this one would lose; recover it with that program</source>
        <translation>{}: un programma successivo ha registrato {}, che una copia fatta da questo perderebbe; recuperarla con quel programma</translation>
    </message>
    <message>
        <source>{}: a link to another place; a recording holds its own values</source>
        <translation>{}: un collegamento a un altro posto; una registrazione contiene i propri valori</translation>
    </message>
    <message>
        <source>{}: a recording is played, nothing is saved: a calibration is made on a touchpad</source>
        <translation>{}: si riproduce una registrazione, nulla è salvato: una calibrazione si fa su un touchpad</translation>
    </message>
    <message>
        <source>{}: a report ends in .html or .pdf</source>
        <translation>{}: un rapporto termina in .html o .pdf</translation>
    </message>
    <message>
        <source>{}: a size in it is beyond all reason</source>
        <translation>{}: contiene una dimensione fuori da ogni misura</translation>
    </message>
    <message>
        <source>{}: a table has no pictures of which to take the region</source>
        <translation>{}: una tabella non ha immagini di cui prendere la regione</translation>
    </message>
    <message>
        <source>{}: a text of {} bytes</source>
        <translation>{}: un testo di {} byte</translation>
    </message>
    <message>
        <source>{}: a video has no fields to choose</source>
        <translation>{}: un video non ha campi da scegliere</translation>
    </message>
    <message>
        <source>{}: already in {}</source>
        <translation>{}: già in {}</translation>
    </message>
    <message>
        <source>{}: an answer to an earlier question was refused; does the touchpad need longer than device.response_timeout_ms = {}?</source>
        <translation>{}: una risposta a una domanda precedente è stata rifiutata; al touchpad serve più di device.response_timeout_ms = {}?</translation>
    </message>
    <message>
        <source>{}: an export ends in .csv, .mat, .mkv, .avi or .mcap</source>
        <translation>{}: un'esportazione finisce in .csv, .mat, .mkv, .avi o .mcap</translation>
    </message>
    <message>
        <source>{}: an export would end before the recording does; `fyd session recover` makes what can be proven whole first, or export up to an earlier second than {:.3f}</source>
        <translation>{}: un'esportazione finirebbe prima della registrazione; `fyd session recover` rende prima integro ciò che si può provare, oppure esportare fino a un secondo precedente a {:.3f}</translation>
    </message>
    <message>
        <source>{}: another recording has this name now; open it again</source>
        <translation>{}: questo nome ora è di un'altra registrazione; riaprirla</translation>
    </message>
    <message>
        <source>{}: another recording is being started</source>
        <translation>{}: un'altra registrazione sta iniziando</translation>
    </message>
    <message>
        <source>{}: another touchpad answers: '{}', expected '{}'; plug the right one in, or open a session for this one</source>
        <translation>{}: risponde un altro touchpad: '{}', atteso '{}'; collegare quello giusto, o aprire una sessione per questo</translation>
    </message>
    <message>
        <source>{}: asked for {} Bd, the port runs at {} Bd; choose a speed its driver supports</source>
        <translation>{}: chiesti {} Bd, la porta va a {} Bd; scegliere una velocità che il suo driver consente</translation>
    </message>
    <message>
        <source>{}: at most {} values</source>
        <translation>{}: al più {} valori</translation>
    </message>
    <message>
        <source>{}: belongs to another user (uid {}, gid {}), who would lose it; choose another name</source>
        <translation>{}: appartiene a un altro utente (uid {}, gid {}), che lo perderebbe; scegliere un altro nome</translation>
    </message>
    <message>
        <source>{}: body.contact: a soft body has its own; expected none beside body.soft</source>
        <translation>{}: body.contact: un corpo morbido ha il suo; atteso nessuno accanto a body.soft</translation>
    </message>
    <message>
        <source>{}: body.kinetic_friction {}: expected at most body.static_friction, {}</source>
        <translation>{}: body.kinetic_friction {}: atteso al più body.static_friction, {}</translation>
    </message>
    <message>
        <source>{}: body.mesh: expected an OBJ, STL or PLY file</source>
        <translation>{}: body.mesh: atteso un file OBJ, STL o PLY</translation>
    </message>
    <message>
        <source>{}: body.position_mm: expected three numbers</source>
        <translation>{}: body.position_mm: attesi tre numeri</translation>
    </message>
    <message>
        <source>{}: body.turned_deg: expected three numbers</source>
        <translation>{}: body.turned_deg: attesi tre numeri</translation>
    </message>
    <message>
        <source>{}: body.velocity_mm_per_s: expected three numbers</source>
        <translation>{}: body.velocity_mm_per_s: attesi tre numeri</translation>
    </message>
    <message>
        <source>{}: bytes {}+{} of {}</source>
        <translation>{}: byte {}+{} di {}</translation>
    </message>
    <message>
        <source>{}: calibrated on the simulated touchpad, which a real one does not use: the defaults are used instead ({})</source>
        <translation>{}: calibrato sul touchpad simulato, che uno vero non usa: si usano invece i valori predefiniti ({})</translation>
    </message>
    <message>
        <source>{}: cannot be deleted: {}</source>
        <translation>{}: non può essere cancellato: {}</translation>
    </message>
    <message>
        <source>{}: cannot be made a link to {}: {}</source>
        <translation>{}: non può diventare un collegamento a {}: {}</translation>
    </message>
    <message>
        <source>{}: cannot be named {}: {}</source>
        <translation>{}: non può essere chiamato {}: {}</translation>
    </message>
    <message>
        <source>{}: cannot be opened: {}</source>
        <translation>{}: non si può aprire: {}</translation>
    </message>
    <message>
        <source>{}: cannot be read: it is no file</source>
        <translation>{}: non può essere letto: non è un file</translation>
    </message>
    <message>
        <source>{}: cannot be read: {}</source>
        <translation>{}: non si può leggere: {}</translation>
    </message>
    <message>
        <source>{}: cannot be set up: {}</source>
        <translation>{}: non può essere impostata: {}</translation>
    </message>
    <message>
        <source>{}: cannot be written</source>
        <translation>{}: non può essere scritto</translation>
    </message>
    <message>
        <source>{}: cannot be written or opened ({}); check the folder's permissions</source>
        <translation>{}: non può essere scritto o aperto ({}); controllare i permessi della cartella</translation>
    </message>
    <message>
        <source>{}: cannot be written: another program takes its part files away</source>
        <translation>{}: non può essere scritto: un altro programma porta via i suoi file parziali</translation>
    </message>
    <message>
        <source>{}: cannot be written: {}</source>
        <translation>{}: non si può scrivere: {}</translation>
    </message>
    <message>
        <source>{}: changed while it was copied; is it still being recorded?</source>
        <translation>{}: cambiato mentre veniva copiato; è ancora in registrazione?</translation>
    </message>
    <message>
        <source>{}: column {} is not of this format's type</source>
        <translation>{}: la colonna {} non è del tipo di questo formato</translation>
    </message>
    <message>
        <source>{}: depth_mm is {}; expected 0 to {}</source>
        <translation>{}: depth_mm vale {}; atteso da 0 a {}</translation>
    </message>
    <message>
        <source>{}: does not count the tables' rows</source>
        <translation>{}: non conta le righe delle tabelle</translation>
    </message>
    <message>
        <source>{}: does not open: {}</source>
        <translation>{}: non si apre: {}</translation>
    </message>
    <message>
        <source>{}: does not open; {}</source>
        <translation>{}: non si apre; {}</translation>
    </message>
    <message>
        <source>{}: empty; expected a header with {}</source>
        <translation>{}: vuoto; attesa un'intestazione con {}</translation>
    </message>
    <message>
        <source>{}: everything needed is there. Arm to start.</source>
        <translation>{}: c'è tutto il necessario. Armare per iniziare.</translation>
    </message>
    <message>
        <source>{}: exists already</source>
        <translation>{}: esiste già</translation>
    </message>
    <message>
        <source>{}: exists; a recording never replaces a file</source>
        <translation>{}: esiste; una registrazione non sostituisce mai un file</translation>
    </message>
    <message>
        <source>{}: exists; move one of the two away first</source>
        <translation>{}: esiste; spostare prima uno dei due</translation>
    </message>
    <message>
        <source>{}: expected [[record.{}]]</source>
        <translation>{}: atteso [[record.{}]]</translation>
    </message>
    <message>
        <source>{}: expected a folder</source>
        <translation>{}: attesa una cartella</translation>
    </message>
    <message>
        <source>{}: expected a list of numbers</source>
        <translation>{}: attesa una lista di numeri</translation>
    </message>
    <message>
        <source>{}: expected an ordinary file</source>
        <translation>{}: atteso un file normale</translation>
    </message>
    <message>
        <source>{}: expected at least one [[band]]</source>
        <translation>{}: attesa almeno una [[band]]</translation>
    </message>
    <message>
        <source>{}: expected numbers with a point</source>
        <translation>{}: attesi numeri con un punto</translation>
    </message>
    <message>
        <source>{}: expected true or false</source>
        <translation>{}: atteso true o false</translation>
    </message>
    <message>
        <source>{}: expected {}</source>
        <translation>{}: atteso {}</translation>
    </message>
    <message>
        <source>{}: expected {}, in quotes</source>
        <translation>{}: atteso {}, tra virgolette</translation>
    </message>
    <message>
        <source>{}: fewer than two different times: the sample rate is unknown</source>
        <translation>{}: meno di due tempi diversi: la frequenza di campionamento è ignota</translation>
    </message>
    <message>
        <source>{}: format {}; this program reads formats {} to {}</source>
        <translation>{}: formato {}; questo programma legge i formati da {} a {}</translation>
    </message>
    <message>
        <source>{}: gives no picture any more</source>
        <translation>{}: non dà più immagini</translation>
    </message>
    <message>
        <source>{}: gone while it was read</source>
        <translation>{}: sparito mentre veniva letto</translation>
    </message>
    <message>
        <source>{}: has no checksums</source>
        <translation>{}: non ha somme di controllo</translation>
    </message>
    <message>
        <source>{}: held-out error {} of at most {:g} mm, falls at every code from {:.0f} to {:.0f}</source>
        <translation>{}: errore di verifica {} su al più {:g} mm, decresce a ogni codice da {:.0f} a {:.0f}</translation>
    </message>
    <message>
        <source>{}: holds no picture</source>
        <translation>{}: non contiene immagini</translation>
    </message>
    <message>
        <source>{}: holds the control character U+{:04X}</source>
        <translation>{}: contiene il carattere di controllo U+{:04X}</translation>
    </message>
    <message>
        <source>{}: in use by another program ("fuser {}" names it)</source>
        <translation>{}: in uso da un altro programma ("fuser {}" lo nomina)</translation>
    </message>
    <message>
        <source>{}: is a device, not a file</source>
        <translation>{}: è un dispositivo, non un file</translation>
    </message>
    <message>
        <source>{}: is a folder, not a file</source>
        <translation>{}: è una cartella, non un file</translation>
    </message>
    <message>
        <source>{}: is a pipe, not a file</source>
        <translation>{}: è una pipe, non un file</translation>
    </message>
    <message>
        <source>{}: is a socket, not a file</source>
        <translation>{}: è un socket, non un file</translation>
    </message>
    <message>
        <source>{}: is another program's database; expected a catalogue, or a new file</source>
        <translation>{}: è la banca dati di un altro programma; atteso un catalogo, o un file nuovo</translation>
    </message>
    <message>
        <source>{}: is being recorded at this moment</source>
        <translation>{}: è in registrazione in questo momento</translation>
    </message>
    <message>
        <source>{}: is damaged; `fyd session recover` keeps what can be proven of it first</source>
        <translation>{}: è danneggiata; `fyd session recover` ne conserva prima ciò che si può provare</translation>
    </message>
    <message>
        <source>{}: is no catalogue, and nothing in it shows that it was one; choose another file, or move it away</source>
        <translation>{}: non è un catalogo, e nulla in esso mostra che lo fosse; scegliere un altro file, o spostarlo</translation>
    </message>
    <message>
        <source>{}: is no serial port</source>
        <translation>{}: non è una porta seriale</translation>
    </message>
    <message>
        <source>{}: is still being recorded; close it first</source>
        <translation>{}: è ancora in registrazione; prima chiuderla</translation>
    </message>
    <message>
        <source>{}: is {} itself under another name, not a copy; nothing was removed</source>
        <translation>{}: è {} stesso con un altro nome, non una copia; nulla è stato rimosso</translation>
    </message>
    <message>
        <source>{}: it is not the file any more that was written</source>
        <translation>{}: non è più il file che è stato scritto</translation>
    </message>
    <message>
        <source>{}: its calibrations do not tell on which touchpad they were made; they are used with {}</source>
        <translation>{}: le sue calibrazioni non dicono su quale touchpad sono state fatte; sono usate con: {}</translation>
    </message>
    <message>
        <source>{}: its columns are not those of this format</source>
        <translation>{}: le sue colonne non sono quelle di questo formato</translation>
    </message>
    <message>
        <source>{}: its links run in a circle</source>
        <translation>{}: i suoi collegamenti girano in tondo</translation>
    </message>
    <message>
        <source>{}: its mesh is not walkable; expected one for a rigid body</source>
        <translation>{}: la sua mesh non si può percorrere; attesa una per un corpo rigido</translation>
    </message>
    <message>
        <source>{}: its server_encoding is {}; make the database with ENCODING 'UTF8'</source>
        <translation>{}: il suo server_encoding è {}; creare il database con ENCODING 'UTF8'</translation>
    </message>
    <message>
        <source>{}: its values lie in other datasets; a recording holds its own</source>
        <translation>{}: i suoi valori stanno in altri dataset; una registrazione contiene i propri</translation>
    </message>
    <message>
        <source>{}: its values lie in other files; a recording holds its own</source>
        <translation>{}: i suoi valori stanno in altri file; una registrazione contiene i propri</translation>
    </message>
    <message>
        <source>{}: its {} bytes are no picture</source>
        <translation>{}: i suoi {} byte non sono un'immagine</translation>
    </message>
    <message>
        <source>{}: its {} bytes are no picture as the recorder writes it</source>
        <translation>{}: i suoi {} byte non sono un'immagine come la scrive il registratore</translation>
    </message>
    <message>
        <source>{}: lies on {}; a recording needs a local disk, whose promise to have written can be trusted</source>
        <translation>{}: sta su {}; una registrazione ha bisogno di un disco locale, di cui si possa credere che abbia scritto</translation>
    </message>
    <message>
        <source>{}: locked by another program for more than {} s; it is open in {}</source>
        <translation>{}: bloccato da un altro programma da più di {} s; è aperto in {}</translation>
    </message>
    <message>
        <source>{}: made by a newer version of this program (tables {}, this one knows {})</source>
        <translation>{}: creato da una versione più nuova di questo programma (tabelle {}, questo conosce {})</translation>
    </message>
    <message>
        <source>{}: mend that, then arm again</source>
        <translation>{}: porvi rimedio, poi armare di nuovo</translation>
    </message>
    <message>
        <source>{}: name of {} bytes: expected 1 to {} that can be printed</source>
        <translation>{}: name di {} byte: attesi da 1 a {} stampabili</translation>
    </message>
    <message>
        <source>{}: no 'format'; expected a record of calibrations, format = {}</source>
        <translation>{}: manca 'format'; atteso un registro di calibrazioni, format = {}</translation>
    </message>
    <message>
        <source>{}: no line --- between the card's head and its rows; expected one</source>
        <translation>{}: nessuna riga --- tra la testa della scheda e le sue righe; attesa una</translation>
    </message>
    <message>
        <source>{}: no memory for its variables</source>
        <translation>{}: manca memoria per le sue variabili</translation>
    </message>
    <message>
        <source>{}: no mesh by its name; expected .obj, .stl or .ply</source>
        <translation>{}: dal nome non è una mesh; atteso .obj, .stl o .ply</translation>
    </message>
    <message>
        <source>{}: no mesh; expected one</source>
        <translation>{}: nessuna mesh; attesa una</translation>
    </message>
    <message>
        <source>{}: no permission. Add yourself to its group with "sudo usermod -aG {} $USER" and log in again</source>
        <translation>{}: nessun permesso. Aggiungersi al suo gruppo con "sudo usermod -aG {} $USER" e rifare l'accesso</translation>
    </message>
    <message>
        <source>{}: no picture can be made</source>
        <translation>{}: non si può fare alcuna immagine</translation>
    </message>
    <message>
        <source>{}: no picture of this format can be made</source>
        <translation>{}: non si può produrre un'immagine in questo formato</translation>
    </message>
    <message>
        <source>{}: no pseudo-terminal to be had: {}</source>
        <translation>{}: nessuno pseudo-terminale disponibile: {}</translation>
    </message>
    <message>
        <source>{}: no such parameter</source>
        <translation>{}: questo parametro non esiste</translation>
    </message>
    <message>
        <source>{}: no such parameter in this profile</source>
        <translation>{}: nessun parametro di questo nome in questo profilo</translation>
    </message>
    <message>
        <source>{}: no temporary file can be made: {}</source>
        <translation>{}: non si può creare un file temporaneo: {}</translation>
    </message>
    <message>
        <source>{}: no {}; expected "{}" and {} words</source>
        <translation>{}: nessun {}; atteso "{}" e {} parole</translation>
    </message>
    <message>
        <source>{}: no {}; expected {}</source>
        <translation>{}: manca {}; atteso {}</translation>
    </message>
    <message>
        <source>{}: not UTF-8</source>
        <translation>{}: non è UTF-8</translation>
    </message>
    <message>
        <source>{}: not a dataset</source>
        <translation>{}: non è un dataset</translation>
    </message>
    <message>
        <source>{}: not a file's name</source>
        <translation>{}: non è il nome di un file</translation>
    </message>
    <message>
        <source>{}: not a folder</source>
        <translation>{}: non è una cartella</translation>
    </message>
    <message>
        <source>{}: not a group as a recording has it</source>
        <translation>{}: non è un gruppo come quelli di una registrazione</translation>
    </message>
    <message>
        <source>{}: not a list of rows</source>
        <translation>{}: non è una lista di righe</translation>
    </message>
    <message>
        <source>{}: not a text</source>
        <translation>{}: non è un testo</translation>
    </message>
    <message>
        <source>{}: not a touchpad: its first registers say 0x{:08X}, expected 0x{:08X}</source>
        <translation>{}: non è un touchpad: i suoi primi registri dicono 0x{:08X}, atteso 0x{:08X}</translation>
    </message>
    <message>
        <source>{}: not all of it could be written; is the disk full?</source>
        <translation>{}: non tutto si è potuto scrivere; il disco è pieno?</translation>
    </message>
    <message>
        <source>{}: not bytes</source>
        <translation>{}: non sono byte</translation>
    </message>
    <message>
        <source>{}: not in chunks of {} rows{}, as this program stores it: another program packed it anew</source>
        <translation>{}: non in blocchi di {} righe{}, come lo salva questo programma: un altro programma lo ha ricompresso</translation>
    </message>
    <message>
        <source>{}: not in one piece</source>
        <translation>{}: non in un solo pezzo</translation>
    </message>
    <message>
        <source>{}: not kept, nothing is being recorded</source>
        <translation>{}: non conservata, nulla è in registrazione</translation>
    </message>
    <message>
        <source>{}: not kept, the session is closed</source>
        <translation>{}: non conservata, la sessione è chiusa</translation>
    </message>
    <message>
        <source>{}: not one number</source>
        <translation>{}: non un solo numero</translation>
    </message>
    <message>
        <source>{}: not one text</source>
        <translation>{}: non un solo testo</translation>
    </message>
    <message>
        <source>{}: not open</source>
        <translation>{}: non aperto</translation>
    </message>
    <message>
        <source>{}: not read to its end: the program was asked to end</source>
        <translation>{}: non letto fino alla fine: è stato chiesto al programma di terminare</translation>
    </message>
    <message>
        <source>{}: note {}: {}</source>
        <translation>{}: nota {}: {}</translation>
    </message>
    <message>
        <source>{}: notes of another recording of this name; move them away, or choose another name</source>
        <translation>{}: note di un'altra registrazione con questo nome; spostarle altrove, o scegliere un altro nome</translation>
    </message>
    <message>
        <source>{}: nothing more can be recorded: {}</source>
        <translation>{}: non si può registrare altro: {}</translation>
    </message>
    <message>
        <source>{}: nothing to touch; expected a [[body]], [swords], [ball] or [palpation]</source>
        <translation>{}: niente da toccare; atteso un [[body]], [swords], [ball] o [palpation]</translation>
    </message>
    <message>
        <source>{}: on a network share, where SQLite would be damaged; use a local path, or postgresql:…</source>
        <translation>{}: su una condivisione di rete, dove SQLite verrebbe danneggiato; usare un percorso locale, o postgresql:…</translation>
    </message>
    <message>
        <source>{}: only notes and bookmarks are written here</source>
        <translation>{}: qui si scrivono solo note e segnalibri</translation>
    </message>
    <message>
        <source>{}: out of memory</source>
        <translation>{}: memoria esaurita</translation>
    </message>
    <message>
        <source>{}: picture {} was not kept</source>
        <translation>{}: l'immagine {} non è stata conservata</translation>
    </message>
    <message>
        <source>{}: plane.normal_x, normal_y and normal_z are 0: expected a direction</source>
        <translation>{}: plane.normal_x, normal_y e normal_z sono 0: attesa una direzione</translation>
    </message>
    <message>
        <source>{}: pseudo-terminal: {}</source>
        <translation>{}: pseudo-terminale: {}</translation>
    </message>
    <message>
        <source>{}: reads differently each time; copy it to another disk first</source>
        <translation>{}: ogni lettura dà altro; copiarlo prima su un altro disco</translation>
    </message>
    <message>
        <source>{}: refused, nothing is saved: {}</source>
        <translation>{}: rifiutata, nulla viene salvato: {}</translation>
    </message>
    <message>
        <source>{}: register map {}.{}, this program knows {}.x; update the older of the two</source>
        <translation>{}: mappa dei registri {}.{}, questo programma conosce la {}.x; aggiornare il più vecchio dei due</translation>
    </message>
    <message>
        <source>{}: rendering.</source>
        <translation>{}: resa in corso.</translation>
    </message>
    <message>
        <source>{}: room for other rows than asked</source>
        <translation>{}: posto per un numero di righe diverso da quello chiesto</translation>
    </message>
    <message>
        <source>{}: row {} has a list that counts more than it can hold</source>
        <translation>{}: la riga {} ha un elenco che conta più di quanto può contenere</translation>
    </message>
    <message>
        <source>{}: row {} of {}</source>
        <translation>{}: riga {} di {}</translation>
    </message>
    <message>
        <source>{}: row {} says that its text begins at byte {}; expected {} or more, behind the text before it</source>
        <translation>{}: la riga {} dice che il suo testo comincia al byte {}; atteso {} o più, dietro al testo che precede</translation>
    </message>
    <message>
        <source>{}: rows from {} on are packed otherwise</source>
        <translation>{}: le righe da {} in poi sono compresse in altro modo</translation>
    </message>
    <message>
        <source>{}: rows from {} on take {} bytes</source>
        <translation>{}: le righe da {} in poi occupano {} byte</translation>
    </message>
    <message>
        <source>{}: rows from {} on: {}</source>
        <translation>{}: righe da {} in poi: {}</translation>
    </message>
    <message>
        <source>{}: rows of {} bytes; this program's have {}</source>
        <translation>{}: righe di {} byte; quelle di questo programma ne hanno {}</translation>
    </message>
    <message>
        <source>{}: rows {} to {} are damaged: CRC32C {:08x}, committed as {:08x}</source>
        <translation>{}: le righe da {} a {} sono danneggiate: CRC32C {:08x}, confermate come {:08x}</translation>
    </message>
    <message>
        <source>{}: rows {} to {} in one block</source>
        <translation>{}: righe da {} a {} in un blocco</translation>
    </message>
    <message>
        <source>{}: rows {}+{} of {}</source>
        <translation>{}: righe {}+{} di {}</translation>
    </message>
    <message>
        <source>{}: saved values are felt now; go back to the current ones to change it</source>
        <translation>{}: ora si sentono i valori salvati; tornare a quelli attuali per cambiarlo</translation>
    </message>
    <message>
        <source>{}: says to be {} bytes, while {} stand in the file of {} bytes</source>
        <translation>{}: dice di essere di {} byte, mentre {} stanno nel file di {} byte</translation>
    </message>
    <message>
        <source>{}: scene.accuracy "{}": expected a share such as "1%", above 0 and up to 100%</source>
        <translation>{}: scene.accuracy "{}": attesa una quota come "1%", sopra 0 e fino a 100%</translation>
    </message>
    <message>
        <source>{}: sends damaged pictures: {}</source>
        <translation>{}: invia immagini danneggiate: {}</translation>
    </message>
    <message>
        <source>{}: sensors are live, motors are off.</source>
        <translation>{}: sensori vivi, motori spenti.</translation>
    </message>
    <message>
        <source>{}: set it to remote, and close what else drives it</source>
        <translation>{}: metterlo in comando remoto e chiudere ogni altro programma che lo pilota</translation>
    </message>
    <message>
        <source>{}: simulated points, nothing is saved: these values would be used by {}</source>
        <translation>{}: punti simulati, nulla è salvato: questi valori sarebbero usati da: {}</translation>
    </message>
    <message>
        <source>{}: source of {} bytes: expected at most {} that can be printed</source>
        <translation>{}: source di {} byte: attesi al massimo {} stampabili</translation>
    </message>
    <message>
        <source>{}: speed = {}: expected {} to {}</source>
        <translation>{}: speed = {}: atteso da {} a {}</translation>
    </message>
    <message>
        <source>{}: stored, but the source cannot be removed: {}; it is whole in both places</source>
        <translation>{}: archiviato, ma l'originale non può essere rimosso: {}; è intero in entrambi i posti</translation>
    </message>
    <message>
        <source>{}: t_s is {} after {}; time must increase from row to row</source>
        <translation>{}: t_s vale {} dopo {}; il tempo deve crescere di riga in riga</translation>
    </message>
    <message>
        <source>{}: t_s is {}; expected 0 in the first row</source>
        <translation>{}: t_s vale {}; atteso 0 nella prima riga</translation>
    </message>
    <message>
        <source>{}: t_s is {}; expected 0 to {} s</source>
        <translation>{}: t_s vale {}; atteso da 0 a {} s</translation>
    </message>
    <message>
        <source>{}: take points at the cloth's corners, far from its middle, some on the untouched cloth and some pressed down as deep as you can</source>
        <translation>{}: prendere punti agli angoli del tessuto, lontano dal centro, alcuni sul tessuto non toccato e alcuni premuti il più a fondo possibile</translation>
    </message>
    <message>
        <source>{}: the CSV parser could not start</source>
        <translation>{}: il lettore CSV non è partito</translation>
    </message>
    <message>
        <source>{}: the catalogue is damaged ({}); the recordings are not touched by that. `fyd session list --rebuild FOLDER{}` moves the file aside and reads the recordings again</source>
        <translation>{}: il catalogo è danneggiato ({}); le registrazioni non ne sono toccate. `fyd session list --rebuild FOLDER{}` sposta da parte il file e rilegge le registrazioni</translation>
    </message>
    <message>
        <source>{}: the copy cannot get its name: {}</source>
        <translation>{}: la copia non può ricevere il suo nome: {}</translation>
    </message>
    <message>
        <source>{}: the copy reads back differently from the source; the storage is not to be trusted</source>
        <translation>{}: la copia riletta è diversa dall'originale; quella memoria non è affidabile</translation>
    </message>
    <message>
        <source>{}: the device behind the port is gone; is the cable plugged in?</source>
        <translation>{}: il dispositivo dietro la porta è sparito; il cavo è collegato?</translation>
    </message>
    <message>
        <source>{}: the disk does not answer; a file that it still makes is closed at once</source>
        <translation>{}: il disco non risponde; un file che crea ancora viene chiuso subito</translation>
    </message>
    <message>
        <source>{}: the disk does not answer; the file is closed when it does</source>
        <translation>{}: il disco non risponde; il file si chiude quando risponderà</translation>
    </message>
    <message>
        <source>{}: the disk has {:.0f} MB left, fewer than the {:.0f} MB a recording leaves free</source>
        <translation>{}: il disco ha {:.0f} MB liberi, meno dei {:.0f} MB che una registrazione lascia liberi</translation>
    </message>
    <message>
        <source>{}: the disk is full; nothing of this change was kept</source>
        <translation>{}: il disco è pieno; di questa modifica non è rimasto nulla</translation>
    </message>
    <message>
        <source>{}: the entry {} is damaged: {}</source>
        <translation>{}: la voce {} è danneggiata: {}</translation>
    </message>
    <message>
        <source>{}: the folder cannot be made: {}</source>
        <translation>{}: la cartella non può essere creata: {}</translation>
    </message>
    <message>
        <source>{}: the folder cannot be used: {}</source>
        <translation>{}: la cartella non si può usare: {}</translation>
    </message>
    <message>
        <source>{}: the picture could not be made</source>
        <translation>{}: l'immagine non è stata prodotta</translation>
    </message>
    <message>
        <source>{}: the pseudo-terminal has no name</source>
        <translation>{}: lo pseudo-terminale non ha nome</translation>
    </message>
    <message>
        <source>{}: the recorder is not running</source>
        <translation>{}: il registratore non è attivo</translation>
    </message>
    <message>
        <source>{}: the recording has ended</source>
        <translation>{}: la registrazione è finita</translation>
    </message>
    <message>
        <source>{}: the recording holds no picture</source>
        <translation>{}: la registrazione non contiene immagini</translation>
    </message>
    <message>
        <source>{}: the recording holds no step</source>
        <translation>{}: la registrazione non contiene alcun passo</translation>
    </message>
    <message>
        <source>{}: the recording shows no picture for another {:.1f} s</source>
        <translation>{}: la registrazione non mostra immagini per altri {:.1f} s</translation>
    </message>
    <message>
        <source>{}: the session is closed</source>
        <translation>{}: la sessione è chiusa</translation>
    </message>
    <message>
        <source>{}: the touchpad does not answer.</source>
        <translation>{}: il touchpad non risponde.</translation>
    </message>
    <message>
        <source>{}: there is a file of this name already</source>
        <translation>{}: c'è già un file con questo nome</translation>
    </message>
    <message>
        <source>{}: there is another file of this name; nothing was moved</source>
        <translation>{}: c'è un altro file con questo nome; nulla è stato spostato</translation>
    </message>
    <message>
        <source>{}: there is no such file</source>
        <translation>{}: questo file non esiste</translation>
    </message>
    <message>
        <source>{}: there is no such port; is the cable plugged in?</source>
        <translation>{}: questa porta non esiste; il cavo è collegato?</translation>
    </message>
    <message>
        <source>{}: these notes are of another recording, {}; expected {}</source>
        <translation>{}: queste note sono di un'altra registrazione, {}; attesa {}</translation>
    </message>
    <message>
        <source>{}: too many changes at once</source>
        <translation>{}: troppe modifiche in una volta</translation>
    </message>
    <message>
        <source>{}: too many of this name; move them away</source>
        <translation>{}: troppi con questo nome; spostarli altrove</translation>
    </message>
    <message>
        <source>{}: unknown key '{}' in {}</source>
        <translation>{}: chiave sconosciuta '{}' in {}</translation>
    </message>
    <message>
        <source>{}: unknown parameter '{}'; '{}' lists those there are</source>
        <translation>{}: parametro sconosciuto '{}'; '{}' elenca quelli esistenti</translation>
    </message>
    <message>
        <source>{}: was left behind by a crash; `fyd session recover` makes it whole first</source>
        <translation>{}: lasciata indietro da un arresto improvviso; prima `fyd session recover` la rende intera</translation>
    </message>
    <message>
        <source>{}: what waits for catalogues is damaged ({}); the recordings are not touched by that. Move the file away, then `fyd session list --rebuild FOLDER` for each catalogue reads the recordings again</source>
        <translation>{}: ciò che attende i cataloghi è danneggiato ({}); le registrazioni non ne sono toccate. Spostare via il file, poi `fyd session list --rebuild FOLDER` per ogni catalogo rilegge le registrazioni</translation>
    </message>
    <message>
        <source>{}: without a column t_s the sample rate must be given</source>
        <translation>{}: senza una colonna t_s va indicata la frequenza di campionamento</translation>
    </message>
    <message>
        <source>{}: writing failed: {}</source>
        <translation>{}: scrittura non riuscita: {}</translation>
    </message>
    <message>
        <source>{}: writing failed: {}; nothing is left of it</source>
        <translation>{}: la scrittura non è riuscita: {}; non ne resta nulla</translation>
    </message>
    <message>
        <source>{}: writing failed: {}; the file stays as it was</source>
        <translation>{}: la scrittura non è riuscita: {}; il file resta com'era</translation>
    </message>
    <message>
        <source>{}: writing {} failed; is the disk full?</source>
        <translation>{}: scrittura di {} non riuscita; il disco è pieno?</translation>
    </message>
    <message>
        <source>{}: x_mm is {}; expected −{} to {}</source>
        <translation>{}: x_mm vale {}; atteso da −{} a {}</translation>
    </message>
    <message>
        <source>{}: y_mm is {}; expected −{} to {}</source>
        <translation>{}: y_mm vale {}; atteso da −{} a {}</translation>
    </message>
    <message>
        <source>{}: {:.0f} % of the acceleration held out is left; breakaway {:.1f} ± {:.1f} % and {:.1f} ± {:.1f} %, resonance {:.1f} ± {:.1f} Hz at {:.0f}°, damping {:.2f}</source>
        <translation>{}: resta il {:.0f} % dell'accelerazione tenuta da parte; spunto {:.1f} ± {:.1f} % e {:.1f} ± {:.1f} %, risonanza {:.1f} ± {:.1f} Hz a {:.0f}°, smorzamento {:.2f}</translation>
    </message>
    <message>
        <source>{}: {:.1f} MB free, the recording needs {:.1f} MB</source>
        <translation>{}: {:.1f} MB liberi, la registrazione ha bisogno di {:.1f} MB</translation>
    </message>
    <message>
        <source>{}: {} Bd is no speed of this system</source>
        <translation>{}: {} Bd non è una velocità di questo sistema</translation>
    </message>
    <message>
        <source>{}: {} Bd is no speed of this system; expected one of {}</source>
        <translation>{}: {} Bd non è una velocità di questo sistema; attesa una di {}</translation>
    </message>
    <message>
        <source>{}: {} IR sensors and {} motors, expected {} and {}</source>
        <translation>{}: {} sensori IR e {} motori, attesi {} e {}</translation>
    </message>
    <message>
        <source>{}: {} at register {}: {}</source>
        <translation>{}: {} al registro {}: {}</translation>
    </message>
    <message>
        <source>{}: {} bands; at most {}</source>
        <translation>{}: {} bande; al più {}</translation>
    </message>
    <message>
        <source>{}: {} bodies; at most {}</source>
        <translation>{}: {} corpi; al più {}</translation>
    </message>
    <message>
        <source>{}: {} bytes</source>
        <translation>{}: {} byte</translation>
    </message>
    <message>
        <source>{}: {} bytes long, at most {} are catalogued</source>
        <translation>{}: lungo {} byte, se ne catalogano al più {}</translation>
    </message>
    <message>
        <source>{}: {} bytes with control characters; expected {}</source>
        <translation>{}: {} byte con caratteri di controllo; atteso {}</translation>
    </message>
    <message>
        <source>{}: {} bytes, expected at most {}</source>
        <translation>{}: {} byte, attesi al massimo {}</translation>
    </message>
    <message>
        <source>{}: {} bytes; expected {}</source>
        <translation>{}: {} byte; atteso {}</translation>
    </message>
    <message>
        <source>{}: {} cannot change while the station runs; a preset holds live parameters only</source>
        <translation>{}: {} non può cambiare mentre la stazione lavora; una preimpostazione contiene solo parametri modificabili dal vivo</translation>
    </message>
    <message>
        <source>{}: {} follows {}; expected rising values</source>
        <translation>{}: {} segue {}; attesi valori crescenti</translation>
    </message>
    <message>
        <source>{}: {} in one step</source>
        <translation>{}: {} in un passo</translation>
    </message>
    <message>
        <source>{}: {} is no calibrated value, nothing is saved</source>
        <translation>{}: {} non è un valore calibrato, nulla è salvato</translation>
    </message>
    <message>
        <source>{}: {} is no folder</source>
        <translation>{}: {} non è una cartella</translation>
    </message>
    <message>
        <source>{}: {} is still being recorded; stop it first</source>
        <translation>{}: {} è ancora in registrazione; fermarla prima</translation>
    </message>
    <message>
        <source>{}: {} rows a second; expected {} and more: are the times in seconds?</source>
        <translation>{}: {} righe al secondo; attese {} o più: i tempi sono in secondi?</translation>
    </message>
    <message>
        <source>{}: {} rows of {} bytes each, while the whole file takes {} bytes</source>
        <translation>{}: {} righe di {} byte ciascuna, mentre l'intero file occupa {} byte</translation>
    </message>
    <message>
        <source>{}: {} rows of {} fields are {:.1f} GiB, a MATLAB 5 file takes 2; choose fewer fields or a shorter time</source>
        <translation>{}: {} righe di {} campi sono {:.1f} GiB, un file MATLAB 5 ne prende 2; scegliere meno campi o un tempo più breve</translation>
    </message>
    <message>
        <source>{}: {} rows: expected two and more</source>
        <translation>{}: {} righe: attese due o più</translation>
    </message>
    <message>
        <source>{}: {} values; expected at most {}</source>
        <translation>{}: {} valori; attesi al più {}</translation>
    </message>
    <message>
        <source>{}: {} with {} values: expected one number, or one for each of {} motors</source>
        <translation>{}: {} con {} valori: atteso un numero, o uno per ciascuno dei {} motori</translation>
    </message>
    <message>
        <source>{}: {} without '{}'</source>
        <translation>{}: {} senza '{}'</translation>
    </message>
    <message>
        <source>{}: {} × {} pixels; at most {} are read</source>
        <translation>{}: {} × {} pixel; se ne leggono al più {}</translation>
    </message>
    <message>
        <source>{}: {}, {} times in a row</source>
        <translation>{}: {}, {} volte di seguito</translation>
    </message>
    <message>
        <source>{}: {}. {} Then re-arm.</source>
        <translation>{}: {}. {} Poi riarmare.</translation>
    </message>
    <message>
        <source>{}: {}: expected a text in quotes</source>
        <translation>{}: {}: atteso un testo tra virgolette</translation>
    </message>
    <message>
        <source>{}: {}: expected true or false</source>
        <translation>{}: {}: atteso true o false</translation>
    </message>
    <message>
        <source>{}: {}; the recording stays at {}</source>
        <translation>{}: {}; la registrazione resta in {}</translation>
    </message>
    <message>
        <source>{}: {}; {}. Then re-arm.</source>
        <translation>{}: {}; {}. Poi riarmare.</translation>
    </message>
    <message>
        <source>{}: {}{}: expected a number from {} to {}</source>
        <translation>{}: {}{}: atteso un numero da {} a {}</translation>
    </message>
    <message>
        <source>{}: {}{}: expected {}</source>
        <translation>{}: {}{}: atteso {}</translation>
    </message>
    <message>
        <source>{}:1: format = "{}": expected "{}"</source>
        <translation>{}:1: format = "{}": atteso "{}"</translation>
    </message>
    <message>
        <source>{}:{}: a key of more than {} parts; expected a table and a name</source>
        <translation>{}:{}: una chiave di più di {} parti; attesi una tabella e un nome</translation>
    </message>
    <message>
        <source>{}:{}: column '{}' stands there more than once; expected each name once</source>
        <translation>{}:{}: la colonna '{}' c'è più di una volta; atteso ogni nome una volta</translation>
    </message>
    <message>
        <source>{}:{}: column {}: '{}' is not a number</source>
        <translation>{}:{}: colonna {}: '{}' non è un numero</translation>
    </message>
    <message>
        <source>{}:{}: delay {} ms: expected 0 to 60000, or nan for a loss</source>
        <translation>{}:{}: ritardo {} ms: atteso da 0 a 60000, o nan per una perdita</translation>
    </message>
    <message>
        <source>{}:{}: more than {} columns; expected a table of measurements</source>
        <translation>{}:{}: più di {} colonne; attesa una tabella di misure</translation>
    </message>
    <message>
        <source>{}:{}: no column '{}'; expected {}</source>
        <translation>{}:{}: nessuna colonna '{}'; attese {}</translation>
    </message>
    <message>
        <source>{}:{}: not valid CSV: {}</source>
        <translation>{}:{}: CSV non valido: {}</translation>
    </message>
    <message>
        <source>{}:{}: t_s = {} after {}: expected times that do not go backwards</source>
        <translation>{}:{}: t_s = {} dopo {}: attesi tempi che non tornano indietro</translation>
    </message>
    <message>
        <source>{}:{}: t_s = {}: expected a finite time in seconds</source>
        <translation>{}:{}: t_s = {}: atteso un tempo finito in secondi</translation>
    </message>
    <message>
        <source>{}:{}: t_s is {} after {}; time must increase from row to row</source>
        <translation>{}:{}: t_s è {} dopo {}; il tempo deve crescere da riga a riga</translation>
    </message>
    <message>
        <source>{}:{}: t_s is {}; expected a time in seconds</source>
        <translation>{}:{}: t_s è {}; atteso un tempo in secondi</translation>
    </message>
    <message>
        <source>{}:{}: time {} s: expected times that start at 0 and rise</source>
        <translation>{}:{}: tempo {} s: attesi tempi che iniziano da 0 e crescono</translation>
    </message>
    <message>
        <source>{}:{}: {} = {}: expected a number from {} to {}</source>
        <translation>{}:{}: {} = {}: atteso un numero da {} a {}</translation>
    </message>
    <message>
        <source>{}:{}: {} fields; the header has {}</source>
        <translation>{}:{}: {} campi; l'intestazione ne ha {}</translation>
    </message>
    <message>
        <source>{}:{}: {} is {}; expected millimetres within ±{}</source>
        <translation>{}:{}: {} è {}; attesi millimetri entro ±{}</translation>
    </message>
    <message>
        <source>{}:{}: {} ms after the row before; expected a row each millisecond</source>
        <translation>{}:{}: {} ms dopo la riga precedente; attesa una riga ogni millisecondo</translation>
    </message>
    <message>
        <source>{}:{}: {} of x_mm, y_mm, z_mm are NaN; all three mean a lifted finger, otherwise none may be</source>
        <translation>{}:{}: {} di x_mm, y_mm, z_mm sono NaN; tutti e tre significano un dito sollevato, altrimenti nessuno può esserlo</translation>
    </message>
    <message>
        <source>{}:{}: {}: expected one of {}</source>
        <translation>{}:{}: {}: atteso uno di {}</translation>
    </message>
    <message>
        <source>{}:{}: {}: expected {}</source>
        <translation>{}:{}: {}: atteso {}</translation>
    </message>
    <message>
        <source>{}; WARNING: {}</source>
        <translation>{}; ATTENZIONE: {}</translation>
    </message>
    <message>
        <source>{}; make what can be proven whole with: fyd session recover</source>
        <translation>{}; rendere intero ciò che si può provare con: fyd session recover</translation>
    </message>
    <message>
        <source>{}; nor can the entry wait: {}. The recording is safe; put it in later with `fyd session add {}`</source>
        <translation>{}; e neppure la voce può attendere: {}. La registrazione è al sicuro; inserirla più tardi con `fyd session add {}`</translation>
    </message>
    <message>
        <source>{}; of {} and {}, move away the notes that are not needed</source>
        <translation>{}; tra {} e {}, spostare altrove le note che non servono</translation>
    </message>
    <message>
        <source>{}; the damaged catalogue is {} now</source>
        <translation>{}; il catalogo danneggiato ora è {}</translation>
    </message>
    <message>
        <source>{}; the entry waits in {} and goes in when the catalogue is next opened</source>
        <translation>{}; la voce attende in {} ed entra alla prossima apertura del catalogo</translation>
    </message>
    <message>
        <source>{}; the former devices could not be had again either: {}</source>
        <translation>{}; neppure i dispositivi precedenti si sono potuti riavere: {}</translation>
    </message>
    <message>
        <source>{}; the former session could not be had again either: {}</source>
        <translation>{}; neppure la sessione precedente si è potuta riavere: {}</translation>
    </message>
    <message>
        <source>{}; the recording is whole in both places, {} and {}: store it again to finish</source>
        <translation>{}; la registrazione è intera in entrambi i posti, {} e {}: archiviarla di nuovo per finire</translation>
    </message>
    <message>
        <source>{}; the recording stays at {}</source>
        <translation>{}; la registrazione resta in {}</translation>
    </message>
    <message>
        <source>{}; {} is whole up to here. Make room or choose another disk</source>
        <translation>{}; {} è integro fin qui. Fare spazio o scegliere un altro disco</translation>
    </message>
    <message>
        <source>{}{}: cannot be renamed to {}: {}</source>
        <translation>{}{}: non può essere rinominato in {}: {}</translation>
    </message>
    <message>
        <source>Δ %1</source>
        <translation>Δ %1</translation>
    </message>
    <message>
        <source>Δt %1</source>
        <translation>Δt %1</translation>
    </message>
    <message>
        <source>Δt %1 s</source>
        <translation>Δt %1 s</translation>
    </message>
    <message>
        <source>• Save profile</source>
        <translation>• Salva il profilo</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
</context>
</TS>
