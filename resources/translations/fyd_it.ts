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
        <source>%1 %2 ± %3</source>
        <translation>%1 %2 ± %3</translation>
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
        <source>%1 / %2 N/mm</source>
        <translation>%1 / %2 N/mm</translation>
    </message>
    <message>
        <source>%1 = %2 was refused.</source>
        <translation>%1 = %2 è stato rifiutato.</translation>
    </message>
    <message>
        <source>%1 = %2: expected %3</source>
        <translation>%1 = %2: atteso %3</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1 GB</translation>
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
        <source>%1 N/mm at %2 deg is known only to %3 %; expected at most %4 %: press there more often and deeper</source>
        <translation>%1 N/mm a %2 gradi è noto solo al %3 %; atteso al più il %4 %: premere lì più spesso e più a fondo</translation>
    </message>
    <message>
        <source>%1 ago</source>
        <translation>%1 fa</translation>
    </message>
    <message>
        <source>%1 angles are not told apart by their stiffness and were pooled</source>
        <translation>%1 angoli non si distinguono per rigidezza e sono stati uniti</translation>
    </message>
    <message>
        <source>%1 at %2 s: %3</source>
        <translation>%1 a %2 s: %3</translation>
    </message>
    <message>
        <source>%1 by the operator. Motors are off. Arm to start again.</source>
        <translation>%1 dall'operatore. Motori spenti. Armare per ricominciare.</translation>
    </message>
    <message>
        <source>%1 cannot change while the station runs</source>
        <translation>%1 non può cambiare mentre la stazione lavora</translation>
    </message>
    <message>
        <source>%1 different angles; expected at least %2: add presses at an angle between %3 and %4 deg</source>
        <translation>%1 angoli diversi; ne servono almeno %2: aggiungere pressioni a un angolo fra %3 e %4 gradi</translation>
    </message>
    <message>
        <source>%1 different distances in %2 points; expected at least %3: add points between %4 and %5 mm (the same distance again tells only the noise)</source>
        <translation>%1 distanze diverse in %2 punti; ne servono almeno %3: aggiungere punti tra %4 e %5 mm (la stessa distanza ripetuta dice solo il rumore)</translation>
    </message>
    <message>
        <source>%1 different points; expected at least %2: add points, best at the corners of the cloth</source>
        <translation>%1 punti diversi; ne servono almeno %2: aggiungere punti, meglio agli angoli del tessuto</translation>
    </message>
    <message>
        <source>%1 different weights in %2 points; expected at least %3: %4</source>
        <translation>%1 pesi diversi in %2 punti; ne servono almeno %3: %4</translation>
    </message>
    <message>
        <source>%1 does not answer: %2</source>
        <translation>%1 non risponde: %2</translation>
    </message>
    <message>
        <source>%1 encoder turns %2 % %3 than commanded; expected within %4 %: check that the motor is free, and that both are wired to the same roller</source>
        <translation>l'encoder %1 gira il %2 % %3 di quanto comandato; atteso entro il %4 %: controllare che il motore sia libero e che entrambi siano collegati allo stesso rullo</translation>
    </message>
    <message>
        <source>%1 encoder: %2 points over %3 deg; expected at least 5 over %4 deg: sweep farther</source>
        <translation>encoder %1: %2 punti su %3 gradi; ne servono almeno 5 su %4 gradi: corsa più lunga</translation>
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
        <source>%1 is being written already.</source>
        <translation>%1 è già in scrittura.</translation>
    </message>
    <message>
        <source>%1 is deleted.</source>
        <translation>%1 è eliminata.</translation>
    </message>
    <message>
        <source>%1 is lost for %2 steps from row %3 on (%4)</source>
        <translation>%1 è perso per %2 passi dalla riga %3 in poi (%4)</translation>
    </message>
    <message>
        <source>%1 is not known: check its cable</source>
        <translation>%1 non è noto: controllare il suo cavo</translation>
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
        <source>%1 is now %2.</source>
        <translation>%1 vale ora %2.</translation>
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
        <source>%1 mV/V is beyond the load cell's span of %2</source>
        <translation>%1 mV/V è oltre il campo della cella di carico di %2</translation>
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
        <source>%1 points at %2 deg; expected at least %3: press there again, to different depths</source>
        <translation>%1 punti a %2 gradi; ne servono almeno %3: premere ancora lì, a profondità diverse</translation>
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
        <source>%1 steps, %2 cycles missed; a step takes %3 µs (median), %4 µs (99th percentile)</source>
        <translation>%1 passi, %2 cicli mancati; un passo dura %3 µs (mediana), %4 µs (99º percentile)</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>da %1 a %2</translation>
    </message>
    <message>
        <source>%1 to %2: the upper end must be the larger one</source>
        <translation>da %1 a %2: l'estremo superiore deve essere il maggiore</translation>
    </message>
    <message>
        <source>%1 was cancelled; no file is left.</source>
        <translation>%1 è stato annullato; non resta alcun file.</translation>
    </message>
    <message>
        <source>%1 · %2 min left</source>
        <translation>%1 · ancora %2 min</translation>
    </message>
    <message>
        <source>%1 · less than 1 min left</source>
        <translation>%1 · meno di 1 min</translation>
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
        <source>%1's newest reading is %2 ms old</source>
        <translation>la lettura più recente di %1 ha %2 ms</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
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
        <source>%1, peak</source>
        <translation>%1, picco</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
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
        <source>%1: %2 is still being recorded; stop it first</source>
        <translation>%1: %2 è ancora in registrazione; fermarla prima</translation>
    </message>
    <message>
        <source>%1: %2 samples are saved, %3 could not be read. The damaged original is kept as %4.</source>
        <translation>%1: %2 campioni salvati, %3 illeggibili. L'originale danneggiato è conservato come %4.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>%1: %2. %3 Then re-arm.</source>
        <translation>%1: %2. %3 Poi riarmare.</translation>
    </message>
    <message>
        <source>%1: '%2' is not a number; expected %3</source>
        <translation>%1: '%2' non è un numero; atteso %3</translation>
    </message>
    <message>
        <source>%1: a report ends in .html or .pdf</source>
        <translation>%1: un rapporto termina in .html o .pdf</translation>
    </message>
    <message>
        <source>%1: all %2 samples are saved, but not all that belongs to them: %3 could not be read. The damaged original is kept as %4.</source>
        <translation>%1: tutti i %2 campioni sono salvati, ma non tutto ciò che li accompagna: %3 illeggibile. L'originale danneggiato è conservato come %4.</translation>
    </message>
    <message>
        <source>%1: an answer to an earlier question was refused; does the touchpad need longer than device.response_timeout_ms = %2?</source>
        <translation>%1: una risposta a una domanda precedente è stata rifiutata; al touchpad serve più di device.response_timeout_ms = %2?</translation>
    </message>
    <message>
        <source>%1: an export would end before the recording does; `fyd session recover` makes what can be proven whole first, or export up to an earlier second than %2</source>
        <translation>%1: un'esportazione finirebbe prima della registrazione; `fyd session recover` rende prima integro ciò che si può provare, oppure esportare fino a un secondo precedente %2</translation>
    </message>
    <message>
        <source>%1: asked for %2 Bd, the port runs at %3 Bd; choose a speed its driver supports</source>
        <translation>%1: chiesti %2 Bd, la porta va a %3 Bd; scegliere una velocità che il suo driver consente</translation>
    </message>
    <message>
        <source>%1: belongs to another user (uid %2, gid %3), who would lose it; choose another name</source>
        <translation>%1: appartiene a un altro utente (uid %2, gid %3), che lo perderebbe; scegliere un altro nome</translation>
    </message>
    <message>
        <source>%1: cannot be opened for reading</source>
        <translation>%1: non si può aprire in lettura</translation>
    </message>
    <message>
        <source>%1: cannot be opened: %2</source>
        <translation>%1: non si può aprire: %2</translation>
    </message>
    <message>
        <source>%1: cannot be read: %2</source>
        <translation>%1: non si può leggere: %2</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2</source>
        <translation>%1: non si può scrivere: %2</translation>
    </message>
    <message>
        <source>%1: difference %2, mean %3</source>
        <translation>%1: differenza %2, media %3</translation>
    </message>
    <message>
        <source>%1: does not open: %2</source>
        <translation>%1: non si apre: %2</translation>
    </message>
    <message>
        <source>%1: does not open; %2</source>
        <translation>%1: non si apre; %2</translation>
    </message>
    <message>
        <source>%1: everything needed is there. Arm to start.</source>
        <translation>%1: c'è tutto il necessario. Armare per iniziare.</translation>
    </message>
    <message>
        <source>%1: exists already</source>
        <translation>%1: esiste già</translation>
    </message>
    <message>
        <source>%1: exists; move one of the two away first</source>
        <translation>%1: esiste; spostare prima uno dei due</translation>
    </message>
    <message>
        <source>%1: expected %2</source>
        <translation>%1: atteso %2</translation>
    </message>
    <message>
        <source>%1: expected a number</source>
        <translation>%1: atteso un numero</translation>
    </message>
    <message>
        <source>%1: expected at least %2 s</source>
        <translation>%1: attesi almeno %2 s</translation>
    </message>
    <message>
        <source>%1: expected true or false</source>
        <translation>%1: atteso true o false</translation>
    </message>
    <message>
        <source>%1: held-out error %2 mm of at most %3 mm, falls at every code from %4 to %5</source>
        <translation>%1: errore di verifica %2 mm su al più %3 mm, decresce a ogni codice da %4 a %5</translation>
    </message>
    <message>
        <source>%1: in use by another program ("fuser %2" names it)</source>
        <translation>%1: in uso da un altro programma ("fuser %2" lo nomina)</translation>
    </message>
    <message>
        <source>%1: is a device, not a file</source>
        <translation>%1: è un dispositivo, non un file</translation>
    </message>
    <message>
        <source>%1: is a folder, not a file</source>
        <translation>%1: è una cartella, non un file</translation>
    </message>
    <message>
        <source>%1: is a pipe, not a file</source>
        <translation>%1: è una pipe, non un file</translation>
    </message>
    <message>
        <source>%1: is a socket, not a file</source>
        <translation>%1: è un socket, non un file</translation>
    </message>
    <message>
        <source>%1: is being recorded at this moment</source>
        <translation>%1: è in registrazione in questo momento</translation>
    </message>
    <message>
        <source>%1: is no serial port</source>
        <translation>%1: non è una porta seriale</translation>
    </message>
    <message>
        <source>%1: its links run in a circle</source>
        <translation>%1: i suoi collegamenti girano in tondo</translation>
    </message>
    <message>
        <source>%1: no permission. Add yourself to its group with "sudo usermod -aG %2 $USER" and log in again</source>
        <translation>%1: nessun permesso. Aggiungersi al suo gruppo con "sudo usermod -aG %2 $USER" e rifare l'accesso</translation>
    </message>
    <message>
        <source>%1: no such parameter</source>
        <translation>%1: questo parametro non esiste</translation>
    </message>
    <message>
        <source>%1: not open</source>
        <translation>%1: non aperto</translation>
    </message>
    <message>
        <source>%1: reads differently each time; copy it to another disk first</source>
        <translation>%1: ogni lettura dà altro; copiarlo prima su un altro disco</translation>
    </message>
    <message>
        <source>%1: rendering.</source>
        <translation>%1: resa in corso.</translation>
    </message>
    <message>
        <source>%1: sends damaged pictures: %2</source>
        <translation>%1: invia immagini danneggiate: %2</translation>
    </message>
    <message>
        <source>%1: sensors are live, motors are off.</source>
        <translation>%1: sensori vivi, motori spenti.</translation>
    </message>
    <message>
        <source>%1: set it to remote, and close what else drives it</source>
        <translation>%1: metterlo in comando remoto e chiudere ogni altro programma che lo pilota</translation>
    </message>
    <message>
        <source>%1: stop, then arm again</source>
        <translation>%1: fermare, poi armare di nuovo</translation>
    </message>
    <message>
        <source>%1: the device behind the port is gone; is the cable plugged in?</source>
        <translation>%1: il dispositivo dietro la porta è sparito; il cavo è collegato?</translation>
    </message>
    <message>
        <source>%1: the disk does not answer; nothing is recorded</source>
        <translation>%1: il disco non risponde; nulla viene registrato</translation>
    </message>
    <message>
        <source>%1: the disk does not answer; the file is closed when it does</source>
        <translation>%1: il disco non risponde; il file si chiude quando risponderà</translation>
    </message>
    <message>
        <source>%1: the disk has %2 MB left, fewer than the %3 MB a recording leaves free</source>
        <translation>%1: il disco ha %2 MB liberi, meno dei %3 MB che una registrazione lascia liberi</translation>
    </message>
    <message>
        <source>%1: the folder cannot be used: %2</source>
        <translation>%1: la cartella non si può usare: %2</translation>
    </message>
    <message>
        <source>%1: the recorder is not running</source>
        <translation>%1: il registratore non è attivo</translation>
    </message>
    <message>
        <source>%1: the recording holds no picture</source>
        <translation>%1: la registrazione non contiene immagini</translation>
    </message>
    <message>
        <source>%1: the session is closed</source>
        <translation>%1: la sessione è chiusa</translation>
    </message>
    <message>
        <source>%1: the touchpad does not answer.</source>
        <translation>%1: il touchpad non risponde.</translation>
    </message>
    <message>
        <source>%1: there is no such file</source>
        <translation>%1: questo file non esiste</translation>
    </message>
    <message>
        <source>%1: there is no such port; is the cable plugged in?</source>
        <translation>%1: questa porta non esiste; il cavo è collegato?</translation>
    </message>
    <message>
        <source>%1: this folder cannot be made</source>
        <translation>%1: questa cartella non può essere creata</translation>
    </message>
    <message>
        <source>%1: too many changes at once</source>
        <translation>%1: troppe modifiche in una volta</translation>
    </message>
    <message>
        <source>%1: type a number first.</source>
        <translation>%1: scrivere prima un numero.</translation>
    </message>
    <message>
        <source>%1: writing failed: %2</source>
        <translation>%1: scrittura non riuscita: %2</translation>
    </message>
    <message>
        <source>%1: writing failed: %2; nothing is left of it</source>
        <translation>%1: la scrittura non è riuscita: %2; non ne resta nulla</translation>
    </message>
    <message>
        <source>%1: writing failed: %2; the file stays as it was</source>
        <translation>%1: la scrittura non è riuscita: %2; il file resta com'era</translation>
    </message>
    <message>
        <source>%1; %2 is whole up to here. Make room or choose another disk</source>
        <translation>%1; %2 è integro fin qui. Fare spazio o scegliere un altro disco</translation>
    </message>
    <message>
        <source>%1; now %2</source>
        <translation>%1; ora %2</translation>
    </message>
    <message>
        <source>%1; robot %2 could not be had again either: %3</source>
        <translation>%1; neppure il robot %2 si è potuto riavere: %3</translation>
    </message>
    <message>
        <source>%1; the former session could not be had again either: %2</source>
        <translation>%1; neppure la sessione precedente si è potuta riavere: %2</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) lost</source>
        <translation><numerusform>%n campione perso</numerusform><numerusform>%n campioni persi</numerusform></translation>
    </message>
    <message>
        <source>/commits: %1 of %2 rows are damaged, the first: row %3</source>
        <translation>/commits: %1 righe su %2 sono danneggiate, la prima: riga %3</translation>
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
        <source>A recording is being recovered already; wait, or cancel it.</source>
        <translation>Un recupero è già in corso; attendere o annullarlo.</translation>
    </message>
    <message>
        <source>A rectangle around the cloth, with a finger in it.</source>
        <translation>Un rettangolo attorno al tessuto, con un dito dentro.</translation>
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
        <source>Accepted and written to %1. The session has begun anew with it; motors stay off until you arm.</source>
        <translation>Accettato e scritto in %1. La sessione è ricominciata con esso; i motori restano spenti finché non si arma.</translation>
    </message>
    <message>
        <source>Accepted. The values are in force and in the profile.</source>
        <translation>Accettato. I valori sono in vigore e nel profilo.</translation>
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
        <translation>Modo adattivo: un dito è più scuro del tessuto illuminato almeno di questa frazione.</translation>
    </message>
    <message>
        <source>Adaptive mode: use every n-th pixel and row, for slow computers.</source>
        <translation>Modo adattivo: usa un pixel e una riga ogni n, per i computer lenti.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Aggiungi</translation>
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
        <source>An indentation less certain than this is unavailable.</source>
        <translation>Un'indentazione meno certa di così non è disponibile.</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Risposte</translation>
    </message>
    <message>
        <source>Asked</source>
        <translation>Chiesto</translation>
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
        <translation>Taratura automatica</translation>
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
        <source>Began, UTC</source>
        <translation>Inizio, UTC</translation>
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
        <source>By hand</source>
        <translation>A mano</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Calibra</translation>
    </message>
    <message>
        <source>Calibrate it again under Calibrate. It does not keep you from arming.</source>
        <translation>Rifare la calibrazione in Calibra. Non impedisce di armare.</translation>
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
        <translation>Annulla la taratura automatica</translation>
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
        <source>Check the camera's cable or choose another source.</source>
        <translation>Controllare il cavo della telecamera o scegliere un'altra sorgente.</translation>
    </message>
    <message>
        <source>Check the load cell's bridge and its cable.</source>
        <translation>Controllare il ponte della cella di carico e il suo cavo.</translation>
    </message>
    <message>
        <source>Check the network and the robot's program.</source>
        <translation>Controllare la rete e il programma del robot.</translation>
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
        <source>Check the touchpad's power and its serial cable.</source>
        <translation>Controllare l'alimentazione del touchpad e il suo cavo seriale.</translation>
    </message>
    <message>
        <source>Choice of curves</source>
        <translation>Scelta delle curve</translation>
    </message>
    <message>
        <source>Choose a session, or write the path of a recording.</source>
        <translation>Scegliere una sessione, o scrivere il percorso di una registrazione.</translation>
    </message>
    <message>
        <source>Choose curves</source>
        <translation>Scegli le curve</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Scegli il file</translation>
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
        <source>Choose the robot's stiffness or set one by hand.</source>
        <translation>Scegliere la rigidezza del robot o impostarne una a mano.</translation>
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
        <source>Click the next mark, type where it lies, and take the point: best at the cloth's corners and in its middle.</source>
        <translation>Fare clic sul segno seguente, scrivere dove si trova e prendere il punto: meglio agli angoli del tessuto e al centro.</translation>
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
        <source>Close the tuning panel</source>
        <translation>Chiudi il pannello di regolazione</translation>
    </message>
    <message>
        <source>Closed loop: cloth and robot answer as identified from this recording.</source>
        <translation>Anello chiuso: tessuto e robot rispondono come identificato da questa registrazione.</translation>
    </message>
    <message>
        <source>Closed: the robot has said goodbye</source>
        <translation>Chiuso: il robot si è congedato</translation>
    </message>
    <message>
        <source>Cloth %1 times its law's stiffness; sensors %2 s late with a lag of %3 s, noise %4 %. The courses above show what the proposal would do. Nothing is changed yet.</source>
        <translation>Tessuto %1 volte la rigidezza della sua legge; sensori in ritardo di %2 s con costante di tempo di %3 s, rumore %4 %. Gli andamenti sopra mostrano che cosa farebbe la proposta. Nulla è ancora cambiato.</translation>
    </message>
    <message>
        <source>Cloth and robot answer (closed loop)</source>
        <translation>Tessuto e robot rispondono (anello chiuso)</translation>
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
        <source>Conditions</source>
        <translation>Condizioni</translation>
    </message>
    <message>
        <source>Conditions: light, temperature, target</source>
        <translation>Condizioni: luce, temperatura, bersaglio</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Connesso</translation>
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
        <source>Corner</source>
        <translation>Taglio</translation>
    </message>
    <message>
        <source>Corner (-3 dB) of the default high-pass.</source>
        <translation>Frequenza di taglio (-3 dB) del passa-alto predefinito.</translation>
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
        <source>Dark theme</source>
        <translation>Tema scuro</translation>
    </message>
    <message>
        <source>Dead band</source>
        <translation>Banda morta</translation>
    </message>
    <message>
        <source>Dead time of the measured stiffness behind the stretch; auto-tune measures it.</source>
        <translation>Tempo morto della rigidezza misurata rispetto alla tensione; la taratura automatica lo misura.</translation>
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
        <source>Depth
mm</source>
        <translation>Profondità
mm</translation>
    </message>
    <message>
        <source>Derivative filter</source>
        <translation>Filtro derivativo</translation>
    </message>
    <message>
        <source>Derivative gain in thesis mode (the thesis used none).</source>
        <translation>Guadagno derivativo nel modo tesi (la tesi non ne usava).</translation>
    </message>
    <message>
        <source>Derivative gain, on the measured stiffness and not on the target.</source>
        <translation>Guadagno derivativo, sulla rigidezza misurata e non sull'obiettivo.</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Dispositivi</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Differenze</translation>
    </message>
    <message>
        <source>Differences, presets, auto-tune, read back</source>
        <translation>Differenze, preimpostazioni, taratura automatica, riletto</translation>
    </message>
    <message>
        <source>Different from %1 s on (%2).</source>
        <translation>Diverso da %1 s in poi (%2).</translation>
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
        <source>Distance sensor %1</source>
        <translation>Sensore di distanza %1</translation>
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
        <source>Drag to look back, wheel to zoom, drag with the right button to zoom into a box,
Ctrl and wheel to stretch this curve, double-click or F to follow again.</source>
        <translation>Trascinare per guardare indietro, rotella per ingrandire, trascinare col tasto destro per ingrandire un riquadro,
Ctrl e rotella per allungare questa curva, doppio clic o F per seguire di nuovo.</translation>
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
        <source>Duties smaller than this become zero, as the motors would not turn.</source>
        <translation>I duty più piccoli di così diventano zero, perché i motori non girerebbero.</translation>
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
        <source>Enough points.</source>
        <translation>Punti sufficienti.</translation>
    </message>
    <message>
        <source>Enter or a double click goes back to a layout.</source>
        <translation>Invio o doppio clic torna a una disposizione.</translation>
    </message>
    <message>
        <source>Enter or a double click opens a session.</source>
        <translation>Invio o doppio clic apre una sessione.</translation>
    </message>
    <message>
        <source>Enter the address and port to listen on, such as 127.0.0.1:3490.</source>
        <translation>Scrivere indirizzo e porta di ascolto, come 127.0.0.1:3490.</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Errore</translation>
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
        <translation>Gli errori di rigidezza fino a questo valore sono lasciati stare (la tesi, nel suo modo, 0.01).</translation>
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
        <source>Everything needed is there; motors off.</source>
        <translation>C'è tutto il necessario; motori spenti.</translation>
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
        <source>FYD Console</source>
        <translation>FYD Console</translation>
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
        <source>Fastest change of the commanded stretch.</source>
        <translation>Massima velocità della tensione comandata.</translation>
    </message>
    <message>
        <source>Fastest the position sent to the robot moves.</source>
        <translation>Massima velocità della posizione inviata al robot.</translation>
    </message>
    <message>
        <source>Feel saved or current values</source>
        <translation>Sentire i valori salvati o quelli attuali</translation>
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
        <source>File of the recording</source>
        <translation>File della registrazione</translation>
    </message>
    <message>
        <source>File: where is the recording to go?</source>
        <translation>File: dove va la registrazione?</translation>
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
        <source>Finger area in pixels</source>
        <translation>Area del dito in pixel</translation>
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
        <source>First encoder's reading at zero stretch.</source>
        <translation>Lettura del primo encoder a tensione zero.</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Adattamento</translation>
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
        <source>Force noise</source>
        <translation>Rumore della forza</translation>
    </message>
    <message>
        <source>Force tare sigma</source>
        <translation>Sigma tara della forza</translation>
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
        <translation>Guadagno della vibrazione; l'operatore del robot lo muove di 0.1.</translation>
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
        <source>How often the robot was silent for longer than the link allows.</source>
        <translation>Quante volte il robot ha taciuto più a lungo di quanto il collegamento permette.</translation>
    </message>
    <message>
        <source>How slowly the measured stiffness follows the true one (time constant); auto-tune measures it.</source>
        <translation>Quanto lentamente la rigidezza misurata segue la vera (costante di tempo); la taratura automatica la misura.</translation>
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
        <source>IR codes %1, expected 0 to %2</source>
        <translation>codici IR %1, attesi da 0 a %2</translation>
    </message>
    <message>
        <source>IR sensor %1</source>
        <translation>Sensore IR %1</translation>
    </message>
    <message>
        <source>IR sensor %1 is stuck at code %2 while the others change: check its cable</source>
        <translation>il sensore IR %1 è fermo al codice %2 mentre gli altri cambiano: controllare il suo cavo</translation>
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
        <source>Integral gain in thesis mode.</source>
        <translation>Guadagno integrale nel modo tesi.</translation>
    </message>
    <message>
        <source>Integral gain, of the relative error.</source>
        <translation>Guadagno integrale, dell'errore relativo.</translation>
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
        <source>Lay the printed target on the cloth, click one of its marks in the picture, type where it lies, and take the point.</source>
        <translation>Posare il bersaglio stampato sul tessuto, fare clic su un suo segno nell'immagine, scrivere dove si trova e prendere il punto.</translation>
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
        <translation>In ascolto su</translation>
    </message>
    <message>
        <source>Listening on</source>
        <translation>Ascolta su</translation>
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
        <source>Look for dirt or an object under the cloth; calibrate.</source>
        <translation>Cercare sporco o un oggetto sotto il tessuto; calibrare.</translation>
    </message>
    <message>
        <source>Looked for: %1
%2

To work without it, start with the simulated camera: leave --camera out.</source>
        <translation>Cercato: %1
%2

Per lavorare senza, avviare con la telecamera simulata: omettere --camera.</translation>
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
        <source>Makes a recording whole whose recorder crashed or that is damaged. Nothing is deleted.</source>
        <translation>Rende integra una registrazione il cui registratore si è interrotto o che è danneggiata. Nulla viene cancellato.</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manuale</translation>
    </message>
    <message>
        <source>Mapping from signal to duty; thesis rounds downward and multiplies by k_vib after the limit.</source>
        <translation>Passaggio dal segnale al duty; thesis arrotonda per difetto e moltiplica per k_vib dopo il limite.</translation>
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
        <source>Motors</source>
        <translation>Motori</translation>
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
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Name a second recording: its curves are drawn faint behind these.</source>
        <translation>Indicare una seconda registrazione: le sue curve sono disegnate tenui dietro queste.</translation>
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
        <source>Name one with --touchpad, --motors or --camera at the start.</source>
        <translation>Indicarne uno con --touchpad, --motors o --camera all'avvio.</translation>
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
        <source>No report: %1.</source>
        <translation>Nessun rapporto: %1.</translation>
    </message>
    <message>
        <source>No sensor of the touchpad answers.</source>
        <translation>Nessun sensore del touchpad risponde.</translation>
    </message>
    <message>
        <source>No serial port and no camera. A touchpad on the network is not searched for: give its address with --touchpad. Simulated parts work without any.</source>
        <translation>Nessuna porta seriale e nessuna telecamera. Un touchpad in rete non viene cercato: darne l'indirizzo con --touchpad. Le parti simulate funzionano senza nulla.</translation>
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
        <source>None</source>
        <translation>Nessuno</translation>
    </message>
    <message>
        <source>Not accepted, the old values stay. %1</source>
        <translation>Non accettato, i vecchi valori restano. %1</translation>
    </message>
    <message>
        <source>Not armed: %1. %2</source>
        <translation>Non armato: %1. %2</translation>
    </message>
    <message>
        <source>Not following: press F to follow again</source>
        <translation>Non segue: premere F per seguire di nuovo</translation>
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
        <translation>Su un tessuto 30 % più morbido di quanto dice la sua legge, con i sensori descritti dal profilo. La taratura automatica ne scopre di più.</translation>
    </message>
    <message>
        <source>On the cloth that auto-tune identified, 30 % softer than its law says.</source>
        <translation>Sul tessuto identificato dalla taratura automatica, 30 % più morbido di quanto dice la sua legge.</translation>
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
        <source>Open</source>
        <translation>Apri</translation>
    </message>
    <message>
        <source>Open loop: the recorded inputs as they were; the cloth does not answer.</source>
        <translation>Anello aperto: gli ingressi registrati com'erano; il tessuto non risponde.</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>Lavoro</translation>
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
        <source>Overshoot</source>
        <translation>Sovraelongazione</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>Pagina del manuale</translation>
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
        <translation>Avanzamento della taratura automatica</translation>
    </message>
    <message>
        <source>Proportional gain in thesis mode.</source>
        <translation>Guadagno proporzionale nel modo tesi.</translation>
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
        <source>Pwm</source>
        <translation>PWM</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Esci</translation>
    </message>
    <message>
        <source>REC %1
%2</source>
        <translation>REC %1
%2</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Radius of the finger's contact with the cloth.</source>
        <translation>Raggio del contatto del dito col tessuto.</translation>
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
        <source>Recordings (*.h5)</source>
        <translation>Registrazioni (*.h5)</translation>
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
        <source>Rest a finger on the cloth, drag a rectangle around the cloth in the picture, and take the point.</source>
        <translation>Appoggiare un dito sul tessuto, trascinare un rettangolo attorno al tessuto nell'immagine e prendere il punto.</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Revisione</translation>
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
        <source>Robot is now: %1.</source>
        <translation>Il robot ora è: %1.</translation>
    </message>
    <message>
        <source>Robot not changed. %1.</source>
        <translation>Robot non cambiato. %1.</translation>
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
        <source>Scale of the spectrum</source>
        <translation>Scala dello spettro</translation>
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
        <source>Serial port</source>
        <translation>Porta seriale</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sessione</translation>
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
        <source>Simulated finger: press on the picture. Depth %1; wheel or Shift and drag changes it.</source>
        <translation>Dito simulato: premere sull'immagine. Profondità %1; rotella o Shift e trascinamento la cambiano.</translation>
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
        <source>Smallest dark area that counts as a touch, in pixels of the 160 × 120 working picture.</source>
        <translation>Minima area scura che conta come tocco, in pixel dell'immagine di lavoro di 160 × 120.</translation>
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
        <source>Speed of playing</source>
        <translation>Velocità di riproduzione</translation>
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
        <source>Stretch</source>
        <translation>Tensione</translation>
    </message>
    <message>
        <source>Stretch angles of the calibration points, rising.</source>
        <translation>Angoli di tensione dei punti di calibrazione, crescenti.</translation>
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
        <source>Tag "%1": expected at most %2 characters.</source>
        <translation>Etichetta "%1": attesi al più %2 caratteri.</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Etichette</translation>
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
        <source>Take everything off the cloth, keep your hands away, and take the point: it lasts 3 s.</source>
        <translation>Togliere tutto dal tessuto, tenere lontane le mani e prendere il punto: dura 3 s.</translation>
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
        <translation>Riprendi l'ultimo punto</translation>
    </message>
    <message>
        <source>Take the load off the cover; check the bridge's wiring.</source>
        <translation>Togliere il carico dalla copertura; controllare il cablaggio del ponte.</translation>
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
        <source>Tare done; the largest offset moved by %1 mm.</source>
        <translation>Tara fatta; l'offset maggiore è cambiato di %1 mm.</translation>
    </message>
    <message>
        <source>Tare failed: %1. Keep the cloth untouched and try again.</source>
        <translation>Tara non riuscita: %1. Non toccare il tessuto e riprovare.</translation>
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
        <source>The camera sees the cloth mirrored left to right.</source>
        <translation>La telecamera vede il tessuto specchiato da sinistra a destra.</translation>
    </message>
    <message>
        <source>The classic protocol cannot tell.</source>
        <translation>Il protocollo classico non può dirlo.</translation>
    </message>
    <message>
        <source>The clock went back by %1 s; that step moved nothing.</source>
        <translation>L'orologio è tornato indietro di %1 s; quel passo non ha mosso nulla.</translation>
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
        <source>The haptic loop says nothing; the last state was %1.</source>
        <translation>Il ciclo aptico tace; l'ultimo stato era %1.</translation>
    </message>
    <message>
        <source>The language changes when the window is started again.</source>
        <translation>La lingua cambia al prossimo avvio della finestra.</translation>
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
        <source>The list of sessions (Ctrl+O)</source>
        <translation>L'elenco delle sessioni (Ctrl+O)</translation>
    </message>
    <message>
        <source>The motors are off. %1 points so far.</source>
        <translation>I motori sono spenti. %1 punti finora.</translation>
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
        <source>The motors move as long as this is held, by mouse or space bar, and are off when it is let go.</source>
        <translation>I motori si muovono finché si tiene premuto, col mouse o con la barra spaziatrice, e sono spenti al rilascio.</translation>
    </message>
    <message>
        <source>The motors move; let go and they are off.</source>
        <translation>I motori si muovono; al rilascio si spengono.</translation>
    </message>
    <message>
        <source>The note is not written: the file of notes is damaged. Mend or move %1.</source>
        <translation>La nota non è scritta: il file delle note è danneggiato. Riparare o spostare %1.</translation>
    </message>
    <message>
        <source>The other session is drawn %1 s later than recorded.</source>
        <translation>L'altra sessione è disegnata %1 s più tardi di quanto registrata.</translation>
    </message>
    <message>
        <source>The proposal was not taken: %1</source>
        <translation>La proposta non è stata accolta: %1</translation>
    </message>
    <message>
        <source>The recording cannot be replayed exactly: the step gave another result the second time. The measured values are safe. Please report this fault with the file.</source>
        <translation>La registrazione non si può riprodurre esattamente: la seconda volta il passo ha dato un altro risultato. I valori misurati sono al sicuro. Segnalare questo difetto con il file.</translation>
    </message>
    <message>
        <source>The recording did not close as it should. %1. What was written before is safe: it is repaired when the file is opened.</source>
        <translation>La registrazione non si è chiusa come doveva. %1. Ciò che era scritto prima è al sicuro: viene riparato quando si apre il file.</translation>
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
        <source>The robot can be changed only while nothing can move. Press Esc first.</source>
        <translation>Il robot si può cambiare solo mentre nulla può muoversi. Premere prima Esc.</translation>
    </message>
    <message>
        <source>The robot must have the same key; "fyd link keygen" makes one.</source>
        <translation>Il robot deve avere la stessa chiave; "fyd link keygen" ne crea una.</translation>
    </message>
    <message>
        <source>The robot's operator asks: %1.</source>
        <translation>L'operatore del robot chiede: %1.</translation>
    </message>
    <message>
        <source>The saved values (A) are felt. Go back to B to change anything.</source>
        <translation>Si sentono i valori salvati (A). Tornare a B per cambiare qualcosa.</translation>
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
        <source>The session has no devices: it is closed. Choose a robot in the link's panel to open it again.</source>
        <translation>La sessione non ha dispositivi: è chiusa. Scegliere un robot nel pannello del collegamento per riaprirla.</translation>
    </message>
    <message>
        <source>The session has no robot; the target is set by hand.</source>
        <translation>La sessione non ha robot; l'obiettivo si imposta a mano.</translation>
    </message>
    <message>
        <source>The session is closed. %1. Choose another robot.</source>
        <translation>La sessione è chiusa. %1. Scegliere un altro robot.</translation>
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
        <source>The target is out of reach; rendering the nearest, %1 N/mm.</source>
        <translation>L'obiettivo è fuori portata; si rende il più vicino, %1 N/mm.</translation>
    </message>
    <message>
        <source>The touchpad runs mode thesis; these courses are of mode default.</source>
        <translation>Il touchpad usa il modo thesis; questi andamenti sono del modo default.</translation>
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
        <translation>Modo tesi: i valori di grigio al di sotto sono il dito.</translation>
    </message>
    <message>
        <source>Thesis mode: the robot goes where the finger is, with a jump at each new touch; off: each touch moves it from where it stands.</source>
        <translation>Modo tesi: il robot va dove è il dito, con un salto a ogni nuovo tocco; spento: ogni tocco lo muove da dove si trova.</translation>
    </message>
    <message>
        <source>This angle is taken.</source>
        <translation>Questo angolo è preso.</translation>
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
        <source>Time over which a new method, filter or gain takes over.</source>
        <translation>Tempo nel quale un nuovo metodo, filtro o guadagno subentra.</translation>
    </message>
    <message>
        <source>Time over which the measured stiffness' noise repeats itself; auto-tune measures it.</source>
        <translation>Tempo dopo il quale il rumore della rigidezza misurata si ripete; la taratura automatica lo misura.</translation>
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
        <source>Top</source>
        <translation>Alto</translation>
    </message>
    <message>
        <source>Top edge of the cloth in the camera's picture.</source>
        <translation>Bordo superiore del tessuto nell'immagine della telecamera.</translation>
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
        <source>Type a few letters of a command</source>
        <translation>Scrivere alcune lettere di un comando</translation>
    </message>
    <message>
        <source>Type a stretch and hold the button: the motors go there. Meanwhile press the cloth to three depths, each for a second; points are taken by themselves.</source>
        <translation>Scrivere una tensione e tenere il pulsante: i motori vanno lì. Intanto premere il tessuto a tre profondità, un secondo ciascuna; i punti si prendono da soli.</translation>
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
        <source>Use a preset's values</source>
        <translation>Usa i valori di una preimpostazione</translation>
    </message>
    <message>
        <source>Use the chosen preset's values; one step to undo (Enter on the list)</source>
        <translation>Usa i valori della preimpostazione scelta; un solo passo da annullare (Invio sulla lista)</translation>
    </message>
    <message>
        <source>Use the proposed values; one step to undo</source>
        <translation>Usa i valori proposti; un solo passo da annullare</translation>
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
        <source>Vibration duty, held by the motor board</source>
        <translation>Duty della vibrazione, tenuto dalla scheda motori</translation>
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
        <source>Who</source>
        <translation>Chi</translation>
    </message>
    <message>
        <source>Who measured</source>
        <translation>Chi ha misurato</translation>
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
        <source>Words of the name, the identifier, the help or the group (Ctrl+F)</source>
        <translation>Parole del nome, dell'identificatore, dell'aiuto o del gruppo (Ctrl+F)</translation>
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
        <source>a list of numbers, each from %1 to %2</source>
        <translation>un elenco di numeri, ciascuno da %1 a %2</translation>
    </message>
    <message>
        <source>a motor stands beyond control.motor_limit_deg: check the encoder's zero</source>
        <translation>un motore sta oltre control.motor_limit_deg: controllare lo zero dell'encoder</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>un numero da %1 a %2</translation>
    </message>
    <message>
        <source>a parameter</source>
        <translation>un parametro</translation>
    </message>
    <message>
        <source>a reason that this program does not know</source>
        <translation>un motivo che questo programma non conosce</translation>
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
        <source>a whole number from %1 to %2</source>
        <translation>un numero intero da %1 a %2</translation>
    </message>
    <message>
        <source>a wrong tare of %1 ± %2 is taken into account</source>
        <translation>si tiene conto di una tara errata di %1 ± %2</translation>
    </message>
    <message>
        <source>adaptive follows uneven and changing light; thesis is the printed algorithm.</source>
        <translation>adaptive segue una luce irregolare e variabile; thesis è l'algoritmo stampato.</translation>
    </message>
    <message>
        <source>add weights between %1 and %2 N</source>
        <translation>aggiungere pesi tra %1 e %2 N</translation>
    </message>
    <message>
        <source>address "%1": "%2" is not an %3 address (names other than localhost are not looked up)</source>
        <translation>indirizzo "%1": "%2" non è un indirizzo %3 (i nomi diversi da localhost non si cercano)</translation>
    </message>
    <message>
        <source>address "%1": an IPv6 address stands in brackets, such as [::1]:3490</source>
        <translation>indirizzo "%1": un indirizzo IPv6 sta fra parentesi quadre, come [::1]:3490</translation>
    </message>
    <message>
        <source>address "%1": no port; expected HOST:PORT such as 127.0.0.1:3490 or [::1]:3490</source>
        <translation>indirizzo "%1": manca la porta; atteso HOST:PORT come 127.0.0.1:3490 o [::1]:3490</translation>
    </message>
    <message>
        <source>address "%1": port "%2" is not a whole number from 0 to 65535</source>
        <translation>indirizzo "%1": la porta "%2" non è un numero intero da 0 a 65535</translation>
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
        <source>all presses are about equally deep, so a wrong tare cannot be told from stiffness: press to different depths</source>
        <translation>tutte le pressioni hanno circa la stessa profondità, quindi una tara errata non si distingue dalla rigidezza: premere a profondità diverse</translation>
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
        <source>an axis spreads by %1 g; expected at most %2: it moves: put the robot to rest</source>
        <translation>un asse oscilla di %1 g; atteso al più %2: si muove: mettere il robot a riposo</translation>
    </message>
    <message>
        <source>an unknown state</source>
        <translation>uno stato sconosciuto</translation>
    </message>
    <message>
        <source>another file</source>
        <translation>un altro file</translation>
    </message>
    <message>
        <source>answers missing</source>
        <translation>risposte mancanti</translation>
    </message>
    <message>
        <source>any text of the header may be wrong: %1</source>
        <translation>ogni testo dell'intestazione può essere errato: %1</translation>
    </message>
    <message>
        <source>area</source>
        <translation>area</translation>
    </message>
    <message>
        <source>asked for %1 %, the camera took %2 %</source>
        <translation>chiesto %1 %, la telecamera ha preso %2 %</translation>
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
        <source>at rest %1 g, spread %2 g</source>
        <translation>a riposo %1 g, dispersione %2 g</translation>
    </message>
    <message>
        <source>at rest it measures %1 g; expected 1 within %2: check the counts per g of the sensor</source>
        <translation>a riposo misura %1 g; atteso 1 entro %2: controllare i conteggi per g del sensore</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>auto-tune</source>
        <translation>taratura automatica</translation>
    </message>
    <message>
        <source>average more readings at each distance, target square to the sensor</source>
        <translation>fare la media di più letture a ogni distanza, bersaglio perpendicolare al sensore</translation>
    </message>
    <message>
        <source>back to the saved values</source>
        <translation>ritorno ai valori salvati</translation>
    </message>
    <message>
        <source>before a handshake</source>
        <translation>prima di un handshake</translation>
    </message>
    <message>
        <source>being recorded</source>
        <translation>in registrazione</translation>
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
        <source>calibrated %1 days ago: repeat it</source>
        <translation>calibrato %1 giorni fa: ripetere</translation>
    </message>
    <message>
        <source>calibrated %1 days ago: repeat it soon</source>
        <translation>calibrato %1 giorni fa: ripetere presto</translation>
    </message>
    <message>
        <source>calibrated %1 days in the future: the computer's clock was or is wrong</source>
        <translation>calibrato %1 giorni nel futuro: l'orologio del computer era o è sbagliato</translation>
    </message>
    <message>
        <source>camera device %1: there is no %2; capture devices found: %3</source>
        <translation>telecamera %1: non c'è %2; dispositivi di acquisizione trovati: %3</translation>
    </message>
    <message>
        <source>camera device '%1': there is none; capture devices found: %2</source>
        <translation>telecamera '%1': non esiste; dispositivi di acquisizione trovati: %2</translation>
    </message>
    <message>
        <source>camera: none given</source>
        <translation>telecamera: non indicata</translation>
    </message>
    <message>
        <source>cannot be read back</source>
        <translation>non si può rileggere</translation>
    </message>
    <message>
        <source>changed since it was calibrated %1 days ago</source>
        <translation>cambiato dopo la calibrazione di %1 giorni fa</translation>
    </message>
    <message>
        <source>changed since it was calibrated today</source>
        <translation>cambiata dopo la calibrazione di oggi</translation>
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
        <source>classic, not secured</source>
        <translation>classico, non protetto</translation>
    </message>
    <message>
        <source>clock</source>
        <translation>orologio</translation>
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
        <source>contrast</source>
        <translation>contrasto</translation>
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
        <source>current %1</source>
        <translation>corrente %1</translation>
    </message>
    <message>
        <source>curve: %1</source>
        <translation>curva: %1</translation>
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
        <source>dashed</source>
        <translation>tratteggiata</translation>
    </message>
    <message>
        <source>days left</source>
        <translation>giorni rimasti</translation>
    </message>
    <message>
        <source>default %1</source>
        <translation>predefinito %1</translation>
    </message>
    <message>
        <source>deleting of preset %1</source>
        <translation>eliminazione della preimpostazione %1</translation>
    </message>
    <message>
        <source>device %1: %2 fit: %3; name more of the one that is meant</source>
        <translation>dispositivo %1: %2 corrispondono: %3; precisare quale si intende</translation>
    </message>
    <message>
        <source>device %1: none is plugged in; %2 holds %3</source>
        <translation>dispositivo %1: nessuno è collegato; %2 contiene %3</translation>
    </message>
    <message>
        <source>device restarts</source>
        <translation>riavvii del dispositivo</translation>
    </message>
    <message>
        <source>device test '%1': %2</source>
        <translation>prova del dispositivo '%1': %2</translation>
    </message>
    <message>
        <source>device test: the session is closed</source>
        <translation>prova del dispositivo: la sessione è chiusa</translation>
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
        <source>distance sensor %1</source>
        <translation>sensore di distanza %1</translation>
    </message>
    <message>
        <source>distance sensor %1 reads %2 counts, outside its span: look whether something stands before it</source>
        <translation>il sensore di distanza %1 legge %2 conteggi, fuori dal suo campo: guardare se c'è qualcosa davanti</translation>
    </message>
    <message>
        <source>distances to the untouched cloth %1 mm, spread %2 mm; force %3 N</source>
        <translation>distanze dal tessuto non toccato %1 mm, dispersione %2 mm; forza %3 N</translation>
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
        <source>each ±%1 %2</source>
        <translation>ciascuno ±%1 %2</translation>
    </message>
    <message>
        <source>encoder %1</source>
        <translation>encoder %1</translation>
    </message>
    <message>
        <source>encoder %1 jumped by %2° in %3 ms: check its magnet and cable; stop, then arm again</source>
        <translation>l'encoder %1 è saltato di %2° in %3 ms: controllare magnete e cavo; fermare, poi armare di nuovo</translation>
    </message>
    <message>
        <source>encoder %1 stands still although its motor was sent %2° further: check the motors' supply and the encoder's cable; stop, then arm again</source>
        <translation>l'encoder %1 è fermo benché il suo motore sia stato mandato %2° più in là: controllare l'alimentazione dei motori e il cavo dell'encoder; fermare, poi armare di nuovo</translation>
    </message>
    <message>
        <source>encoder %1: %2, zero at %3 counts, swept from %4 to %5</source>
        <translation>encoder %1: %2, zero a %3 conteggi, percorso da %4 a %5</translation>
    </message>
    <message>
        <source>encoder counts %1, expected 0 to %2</source>
        <translation>conteggi degli encoder %1, attesi da 0 a %2</translation>
    </message>
    <message>
        <source>encoders</source>
        <translation>encoder</translation>
    </message>
    <message>
        <source>ended: a motor was not where it was sent; check its encoder and that it can turn</source>
        <translation>terminata: un motore non era dove è stato mandato; controllare il suo encoder e che possa girare</translation>
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
        <source>exception 6: it is busy, another program drives its motors; close that one</source>
        <translation>eccezione 6: è occupato, un altro programma comanda i suoi motori; chiuderlo</translation>
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
        <source>fault reaction active</source>
        <translation>reazione al guasto in corso</translation>
    </message>
    <message>
        <source>field</source>
        <translation>campo</translation>
    </message>
    <message>
        <source>figures from %1 s to %2 s: expected two times</source>
        <translation>valori da %1 s a %2 s: attesi due tempi</translation>
    </message>
    <message>
        <source>file missing</source>
        <translation>file mancante</translation>
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
        <source>finger</source>
        <translation>dito</translation>
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
        <source>flat picture</source>
        <translation>immagine piatta</translation>
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
        <source>gives no picture any more</source>
        <translation>non dà più immagini</translation>
    </message>
    <message>
        <source>has said goodbye</source>
        <translation>si è congedato</translation>
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
        <source>held-out error %1 N of at most %2 N over %3 weights</source>
        <translation>errore di verifica %1 N su al più %2 N con %3 pesi</translation>
    </message>
    <message>
        <source>held-out error %1 N of at most %2 N; stiffness rises from %3 to %4 N/mm</source>
        <translation>errore di verifica %1 N su al più %2 N; la rigidezza cresce da %3 a %4 N/mm</translation>
    </message>
    <message>
        <source>held-out error %1 N; expected at most %2 N: %3</source>
        <translation>errore di verifica %1 N; atteso al più %2 N: %3</translation>
    </message>
    <message>
        <source>held-out error %1 deg of at most %2 deg</source>
        <translation>errore di verifica %1 deg su al più %2 deg</translation>
    </message>
    <message>
        <source>held-out error %1 deg; expected at most %2: sweep slower, and wait at each angle</source>
        <translation>errore di verifica %1 deg; atteso al più %2: muovere più piano, e attendere a ogni angolo</translation>
    </message>
    <message>
        <source>held-out error %1 mm of at most %2 mm</source>
        <translation>errore di verifica %1 mm su al più %2 mm</translation>
    </message>
    <message>
        <source>held-out error %1 mm; expected at most %2 mm: %3</source>
        <translation>errore di verifica %1 mm; atteso al più %2 mm: %3</translation>
    </message>
    <message>
        <source>holds no picture</source>
        <translation>non contiene immagini</translation>
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
        <source>key file %1: %2</source>
        <translation>file della chiave %1: %2</translation>
    </message>
    <message>
        <source>key file %1: not a regular file</source>
        <translation>file della chiave %1: non è un file normale</translation>
    </message>
    <message>
        <source>key file %1: open to others (mode %2); make it private with: chmod 600 %3</source>
        <translation>file della chiave %1: aperto ad altri (modo %2); renderlo privato con: chmod 600 %3</translation>
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
        <source>left as it is</source>
        <translation>lasciato com'è</translation>
    </message>
    <message>
        <source>less than a minute left</source>
        <translation>meno di un minuto rimasto</translation>
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
        <source>light, temperature, target</source>
        <translation>luce, temperatura, bersaglio</translation>
    </message>
    <message>
        <source>load cell</source>
        <translation>cella di carico</translation>
    </message>
    <message>
        <source>load cell: %1 mV/V lies beyond the bridge's span</source>
        <translation>cella di carico: %1 mV/V è oltre il campo del ponte</translation>
    </message>
    <message>
        <source>loading reads %1 N apart from unloading: look for friction between the cell and its plate</source>
        <translation>il carico differisce di %1 N dallo scarico: cercare attrito fra cella e piastra</translation>
    </message>
    <message>
        <source>look at the distance sensors' curves and at the load cell's cable</source>
        <translation>guardare le curve dei sensori di distanza e il cavo della cella di carico</translation>
    </message>
    <message>
        <source>m/s²</source>
        <translation>m/s²</translation>
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
        <source>measured with another calibration: measure it again</source>
        <translation>misurata con un'altra calibrazione: misurarla di nuovo</translation>
    </message>
    <message>
        <source>measured without the invalid sensors</source>
        <translation>misurato senza i sensori non validi</translation>
    </message>
    <message>
        <source>membrane uses the shape of the pushed cloth and a Kalman filter; thesis a plane, 0.8/0.2 and a 2 mm gate.</source>
        <translation>membrane usa la forma del tessuto premuto e un filtro di Kalman; thesis un piano, 0.8/0.2 e una soglia di 2 mm.</translation>
    </message>
    <message>
        <source>message</source>
        <translation>messaggio</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>more than 5 % of the haptic cycles of one second were missed</source>
        <translation>più del 5 % dei cicli aptici di un secondo è mancato</translation>
    </message>
    <message>
        <source>motor %1</source>
        <translation>motore %1</translation>
    </message>
    <message>
        <source>motor board %1 at %2 %3: stop, then arm again</source>
        <translation>scheda motori %1 su %2 %3: fermare, poi armare di nuovo</translation>
    </message>
    <message>
        <source>motor board %1 at %2: current %3 is %4 mA, expected -%5 to %6</source>
        <translation>scheda motori %1 su %2: la corrente %3 è di %4 mA, attesa da -%5 a %6</translation>
    </message>
    <message>
        <source>motor board %1 at %2: no answer to command %3 in %4 ms; is it on, and are device.qbmove_baud = %5 and device.qbmove_id right?</source>
        <translation>scheda motori %1 su %2: nessuna risposta al comando %3 in %4 ms; è accesa, e device.qbmove_baud = %5 e device.qbmove_id sono giusti?</translation>
    </message>
    <message>
        <source>motor board: nothing received yet</source>
        <translation>scheda motori: ancora niente ricevuto</translation>
    </message>
    <message>
        <source>motor currents %1 mA, expected -%2 to %3</source>
        <translation>correnti dei motori %1 mA, attese da -%2 a %3</translation>
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
        <source>motor temperatures %1 °C, expected %2 to %3</source>
        <translation>temperature dei motori %1 °C, attese da %2 a %3</translation>
    </message>
    <message>
        <source>motors</source>
        <translation>motori</translation>
    </message>
    <message>
        <source>motors at %1 and %2 °C, switched off at %3: let them cool</source>
        <translation>motori a %1 e %2 °C, spenti a %3: lasciarli raffreddare</translation>
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
        <source>never calibrated</source>
        <translation>mai calibrato</translation>
    </message>
    <message>
        <source>no answer in %1 ms; is it switched on and connected?</source>
        <translation>nessuna risposta in %1 ms; è acceso e collegato?</translation>
    </message>
    <message>
        <source>no catalogue was chosen</source>
        <translation>nessun catalogo è stato scelto</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>nessun dato</translation>
    </message>
    <message>
        <source>no device tells '%1': look under Devices whether the touchpad answers</source>
        <translation>nessun dispositivo riferisce '%1': guardare in Dispositivi se il touchpad risponde</translation>
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
        <source>no place yet: click a mark of the target in the picture</source>
        <translation>ancora nessuna posizione: fare clic su un segno del bersaglio nell'immagine</translation>
    </message>
    <message>
        <source>no point between %1 and %2 mm, %3 % of the span: add points between %4 and %5 mm</source>
        <translation>nessun punto tra %1 e %2 mm, %3 % del campo: aggiungere punti tra %4 e %5 mm</translation>
    </message>
    <message>
        <source>no press at %1 deg is deeper than %2 mm; expected at least %3 mm: press deeper there</source>
        <translation>nessuna pressione a %1 gradi supera %2 mm; servono almeno %3 mm: premere di più lì</translation>
    </message>
    <message>
        <source>no recent picture</source>
        <translation>nessuna immagine recente</translation>
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
        <source>no stiffness target</source>
        <translation>nessuna rigidezza desiderata</translation>
    </message>
    <message>
        <source>no value changes: the texture takes rest away by itself</source>
        <translation>nessun valore cambia: la texture toglie da sola il riposo</translation>
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
        <source>not confirmed: the station did not answer. It last used %1.</source>
        <translation>non confermato: la stazione non ha risposto. Da ultimo usava %1.</translation>
    </message>
    <message>
        <source>not ready to switch on</source>
        <translation>non pronto ad accendersi</translation>
    </message>
    <message>
        <source>note</source>
        <translation>nota</translation>
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
        <source>old: %1</source>
        <translation>vecchio: %1</translation>
    </message>
    <message>
        <source>on</source>
        <translation>acceso</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>uno fra %1</translation>
    </message>
    <message>
        <source>operation enabled</source>
        <translation>in funzione</translation>
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
        <source>out of turn</source>
        <translation>fuori turno</translation>
    </message>
    <message>
        <source>parts missing</source>
        <translation>parti mancanti</translation>
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
        <source>polynomial of degree %1</source>
        <translation>polinomio di grado %1</translation>
    </message>
    <message>
        <source>polynomial: c0 + c1 v + ..., constant first; inverse: c0/(v + c1) + c2.</source>
        <translation>polynomial: c0 + c1 v + ..., prima la costante; inverse: c0/(v + c1) + c2.</translation>
    </message>
    <message>
        <source>position duties %1 %, expected -100 to 100</source>
        <translation>duty di posizione %1 %, attesi da -100 a 100</translation>
    </message>
    <message>
        <source>position duty %1</source>
        <translation>duty di posizione %1</translation>
    </message>
    <message>
        <source>preset %1</source>
        <translation>preimpostazione %1</translation>
    </message>
    <message>
        <source>press slower, and hold each depth</source>
        <translation>premere più piano, e tenere ogni profondità</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>proposto</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>quick stop active</source>
        <translation>arresto rapido in corso</translation>
    </message>
    <message>
        <source>reachable</source>
        <translation>raggiungibile</translation>
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
        <source>recorder crashed</source>
        <translation>registratore interrotto</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>registrazione</translation>
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
        <source>resume</source>
        <translation>riprendere</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>robot</translation>
    </message>
    <message>
        <source>robot '%1': FYD Link needs a key file</source>
        <translation>robot '%1': FYD Link richiede un file della chiave</translation>
    </message>
    <message>
        <source>robot '%1': expected simulated, none, link:HOST:PORT or classic:HOST:PORT</source>
        <translation>robot '%1': atteso simulated, none, link:HOST:PORT o classic:HOST:PORT</translation>
    </message>
    <message>
        <source>robot '%1': takes no key file</source>
        <translation>robot '%1': non prende un file della chiave</translation>
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
        <source>saving of preset %1</source>
        <translation>salvataggio della preimpostazione %1</translation>
    </message>
    <message>
        <source>send info and pause</source>
        <translation>inviare informazioni e pausa</translation>
    </message>
    <message>
        <source>sensors contradict each other</source>
        <translation>i sensori si contraddicono</translation>
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
        <source>set to %1 %</source>
        <translation>impostato a %1 %</translation>
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
        <source>slope fits force against indentation with uncertainty; thesis is the bare ratio.</source>
        <translation>slope adatta la forza all'indentazione con incertezza; thesis è il semplice rapporto.</translation>
    </message>
    <message>
        <source>slope per angle, monotone law</source>
        <translation>pendenza per angolo, legge monotona</translation>
    </message>
    <message>
        <source>solid</source>
        <translation>continua</translation>
    </message>
    <message>
        <source>spread x %1, y %2, z %3</source>
        <translation>dispersione x %1, y %2, z %3</translation>
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
        <source>status word</source>
        <translation>parola di stato</translation>
    </message>
    <message>
        <source>stiffness falls from %1 N/mm at %2 deg to %3 at %4 deg, though stretching stiffens the cloth: press at both angles again, and look whether the cloth slips</source>
        <translation>la rigidezza scende da %1 N/mm a %2 gradi a %3 a %4 gradi, benché la tensione irrigidisca il tessuto: premere di nuovo a entrambi gli angoli e guardare se il tessuto scivola</translation>
    </message>
    <message>
        <source>still being recorded</source>
        <translation>ancora in registrazione</translation>
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
        <source>switch-on disabled</source>
        <translation>accensione inibita</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>spenti</translation>
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
        <source>temperature %1</source>
        <translation>temperatura %1</translation>
    </message>
    <message>
        <source>the block changed while it was read (its two sequence numbers differ)</source>
        <translation>il blocco è cambiato durante la lettura (i suoi due numeri di sequenza differiscono)</translation>
    </message>
    <message>
        <source>the camera sees a finger on the cloth: take everything off</source>
        <translation>la telecamera vede un dito sul tessuto: togliere tutto</translation>
    </message>
    <message>
        <source>the camera sees nothing: picture black, white, of one grey or empty</source>
        <translation>la telecamera non vede nulla: immagine nera, bianca, di un solo grigio o vuota</translation>
    </message>
    <message>
        <source>the camera sends no pictures</source>
        <translation>la telecamera non manda immagini</translation>
    </message>
    <message>
        <source>the cloth was touched</source>
        <translation>il tessuto è stato toccato</translation>
    </message>
    <message>
        <source>the disk has less than %1 MB left: recording stopped</source>
        <translation>il disco ha meno di %1 MB liberi: registrazione fermata</translation>
    </message>
    <message>
        <source>the distance sensors are silent</source>
        <translation>i sensori di distanza tacciono</translation>
    </message>
    <message>
        <source>the distance sensors repeat the codes %1 although their count goes on: switch the touchpad off and on</source>
        <translation>i sensori di distanza ripetono i codici %1 benché il loro conteggio prosegua: spegnere e riaccendere il touchpad</translation>
    </message>
    <message>
        <source>the distances span only %1 mm, %2 to %3; expected at least %4: add points between %5 and %6 mm</source>
        <translation>le distanze coprono solo %1 mm, da %2 a %3; ne servono almeno %4: aggiungere punti tra %5 e %6 mm</translation>
    </message>
    <message>
        <source>the haptic loop stood still for more than 20 ms</source>
        <translation>il ciclo aptico è rimasto fermo più di 20 ms</translation>
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
        <source>the load cell repeats %1 mV/V although its count goes on: switch the touchpad off and on</source>
        <translation>la cella di carico ripete %1 mV/V benché il suo conteggio prosegua: spegnere e riaccendere il touchpad</translation>
    </message>
    <message>
        <source>the load cell's value is outside its span</source>
        <translation>il valore della cella di carico è fuori dal suo campo</translation>
    </message>
    <message>
        <source>the motor board is silent</source>
        <translation>la scheda motori tace</translation>
    </message>
    <message>
        <source>the motors are not free: stop the session first</source>
        <translation>i motori non sono liberi: fermare prima la sessione</translation>
    </message>
    <message>
        <source>the motors do not answer</source>
        <translation>i motori non rispondono</translation>
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
        <source>the picture is frozen: the camera sends one and the same; unplug it and plug it in again</source>
        <translation>l'immagine è congelata: la telecamera manda sempre la stessa; scollegarla e ricollegarla</translation>
    </message>
    <message>
        <source>the reading drifts by %1 N over the measurement: let the bridge warm up</source>
        <translation>la lettura deriva di %1 N durante la misura: lasciar scaldare il ponte</translation>
    </message>
    <message>
        <source>the recorder is not running</source>
        <translation>il registratore non è attivo</translation>
    </message>
    <message>
        <source>the recording holds no picture</source>
        <translation>la registrazione non contiene immagini</translation>
    </message>
    <message>
        <source>the recording holds no step</source>
        <translation>la registrazione non contiene passi</translation>
    </message>
    <message>
        <source>the region is %1 × %2 px; expected at least %3 px each way: drag a larger one</source>
        <translation>la regione è di %1 × %2 px; attesi almeno %3 px per lato: trascinarne una più grande</translation>
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
        <source>the status word %1 names no state</source>
        <translation>la parola di stato %1 non indica alcuno stato</translation>
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
        <source>the touchpad answers, but its clock or its count of value sets stands still: switch it off and on</source>
        <translation>il touchpad risponde, ma il suo orologio o il suo conteggio dei gruppi di valori è fermo: spegnerlo e riaccenderlo</translation>
    </message>
    <message>
        <source>the touchpad closed the connection</source>
        <translation>il touchpad ha chiuso la connessione</translation>
    </message>
    <message>
        <source>the touchpad does not obey what is written to it (bit 9 of its status word)</source>
        <translation>il touchpad non obbedisce a ciò che gli viene scritto (bit 9 della sua parola di stato)</translation>
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
        <source>the touchpad's motors are in the state %1 (%2): stop, then arm again</source>
        <translation>i motori del touchpad sono nello stato %1 (%2): fermare, poi armare di nuovo</translation>
    </message>
    <message>
        <source>the touchpad's motors are in the state %1: stop, then arm again</source>
        <translation>i motori del touchpad sono nello stato %1: fermare, poi armare di nuovo</translation>
    </message>
    <message>
        <source>the values do not fit this session</source>
        <translation>i valori non sono adatti a questa sessione</translation>
    </message>
    <message>
        <source>the weights span only %1 N; expected at least %2: %3</source>
        <translation>i pesi coprono solo %1 N; ne servono almeno %2: %3</translation>
    </message>
    <message>
        <source>the window did not answer for half a second</source>
        <translation>la finestra non ha risposto per mezzo secondo</translation>
    </message>
    <message>
        <source>there is no picture: look under Devices whether the camera answers</source>
        <translation>non c'è immagine: guardare in Dispositivi se la telecamera risponde</translation>
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
        <source>this part was never calibrated: accept a calibration first</source>
        <translation>questa parte non è mai stata calibrata: accettare prima una calibrazione</translation>
    </message>
    <message>
        <source>this source has none</source>
        <translation>questa sorgente non ne ha</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>tempo (s)</translation>
    </message>
    <message>
        <source>to</source>
        <translation>a</translation>
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
        <source>too uncertain</source>
        <translation>troppo incerto</translation>
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
        <source>unknown parameter '%1'</source>
        <translation>parametro sconosciuto '%1'</translation>
    </message>
    <message>
        <source>untouched</source>
        <translation>non toccato</translation>
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
        <source>waiting for a robot on %1</source>
        <translation>in attesa di un robot su %1</translation>
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
        <source>whole</source>
        <translation>integra</translation>
    </message>
    <message>
        <source>width</source>
        <translation>larghezza</translation>
    </message>
    <message>
        <source>wrong button</source>
        <translation>pulsante errato</translation>
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
        <source>wrong start or end mark</source>
        <translation>segno di inizio o fine errato</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>x %1 mm   y %2 mm   area %3 px</source>
        <translation>x %1 mm   y %2 mm   area %3 px</translation>
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
        <source>z, g</source>
        <translation>z, g</translation>
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
