<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
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
        <translation> courbes</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>% of target</source>
        <translation>% de la consigne</translation>
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
        <translation>%1 (%2 fois)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 (not there any more)</source>
        <translation>%1 (n'est plus là)</translation>
    </message>
    <message>
        <source>%1 / %2 N/mm</source>
        <translation>%1 / %2 N/mm</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1 Go</translation>
    </message>
    <message>
        <source>%1 Hold still, take the point, and hold on until the bar is full: %2 s.</source>
        <translation>%1 Ne pas bouger, prendre le point, et tenir jusqu'à ce que la barre soit pleine : %2 s.</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 Mo</translation>
    </message>
    <message>
        <source>%1 ago</source>
        <translation>il y a %1</translation>
    </message>
    <message>
        <source>%1 at %2 s: %3</source>
        <translation>%1 à %2 s : %3</translation>
    </message>
    <message>
        <source>%1 comes back at the next start: the file of the window's settings cannot be written.</source>
        <translation>%1 revient au prochain démarrage : le fichier des réglages de la fenêtre ne peut être écrit.</translation>
    </message>
    <message>
        <source>%1 errors since the start</source>
        <translation>%1 erreurs depuis le démarrage</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>%1 h left</source>
        <translation>encore %1 h</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>%1 is also open in %2: here it is not saved, and no calibration accepted.</source>
        <translation>%1 est aussi ouvert dans %2 : ici il n'est pas enregistré, et aucun étalonnage n'est accepté.</translation>
    </message>
    <message>
        <source>%1 is being written already.</source>
        <translation>%1 est déjà en cours d'écriture.</translation>
    </message>
    <message>
        <source>%1 is deleted.</source>
        <translation>%1 est supprimée.</translation>
    </message>
    <message>
        <source>%1 is in use by %2: close that one first</source>
        <translation>%1 est utilisé par %2 : fermer d'abord celle-là</translation>
    </message>
    <message>
        <source>%1 is not saved: the file of the window's settings cannot be written.</source>
        <translation>%1 n'est pas enregistrée : le fichier des réglages de la fenêtre ne peut être écrit.</translation>
    </message>
    <message>
        <source>%1 is not written: %2</source>
        <translation>%1 n'est pas écrit : %2</translation>
    </message>
    <message>
        <source>%1 is saved.</source>
        <translation>%1 est enregistrée.</translation>
    </message>
    <message>
        <source>%1 is whole: %2 samples.</source>
        <translation>%1 est entier : %2 échantillons.</translation>
    </message>
    <message>
        <source>%1 is whole: %2 samples. Nothing was lost; the damaged original is kept as %3.</source>
        <translation>%1 est entier : %2 échantillons. Rien n'est perdu ; l'original endommagé est conservé sous %3.</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 est écrit.</translation>
    </message>
    <message>
        <source>%1 kB</source>
        <translation>%1 ko</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 min left</source>
        <translation>encore %1 min</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 de plus</translation>
    </message>
    <message>
        <source>%1 moves by %2; at rest it stays within %3</source>
        <translation>%1 varie de %2 ; au repos il reste dans %3</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>%1 of %2 samples, %3 times real time.</source>
        <translation>%1 sur %2 échantillons, %3 fois le temps réel.</translation>
    </message>
    <message>
        <source>%1 old</source>
        <translation>vieux de %1</translation>
    </message>
    <message>
        <source>%1 over time, %2</source>
        <translation>%1 au cours du temps, %2</translation>
    </message>
    <message>
        <source>%1 over what is felt; motors %2; too small to turn %3, clipped %4</source>
        <translation>%1 au-dessus de ce qui se sent ; moteurs %2 ; trop faible pour tourner %3, écrêté %4</translation>
    </message>
    <message>
        <source>%1 presses of different depth at %2 or more stretches, the least and the greatest among them.</source>
        <translation>%1 pressions de profondeurs différentes à %2 étirements ou plus, dont le plus faible et le plus fort.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation>%1 s : %2</translation>
    </message>
    <message>
        <source>%1 s: there are values from %2 s to %3 s.</source>
        <translation>%1 s : il y a des valeurs de %2 s à %3 s.</translation>
    </message>
    <message>
        <source>%1 samples are not in the file: the computer is too busy. What is written is safe. Close other programs.</source>
        <translation>%1 échantillons manquent dans le fichier : l'ordinateur est trop occupé. Ce qui est écrit est en sûreté. Fermer les autres programmes.</translation>
    </message>
    <message>
        <source>%1 samples lost</source>
        <translation>%1 échantillons perdus</translation>
    </message>
    <message>
        <source>%1 steps lie beyond the tolerance stated for that.</source>
        <translation>%1 pas sont au-delà de la tolérance indiquée pour cela.</translation>
    </message>
    <message>
        <source>%1 steps, %2 cycles missed since the start; a step takes %3 µs (median), %4 µs (99th percentile)</source>
        <translation>%1 pas, %2 cycles manqués depuis le début ; un pas dure %3 µs (médiane), %4 µs (99e percentile)</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>de %1 à %2</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <translation>de %1 à %2 %3</translation>
    </message>
    <message>
        <source>%1 to %2: the upper end must be the larger one</source>
        <translation>de %1 à %2 : la borne supérieure doit être la plus grande</translation>
    </message>
    <message>
        <source>%1 touch %2</source>
        <translation>%1 toucher %2</translation>
    </message>
    <message>
        <source>%1 triangles · %2 pictures/s</source>
        <translation>%1 triangles · %2 images/s</translation>
    </message>
    <message>
        <source>%1 triangles · nothing moves</source>
        <translation>%1 triangles · rien ne bouge</translation>
    </message>
    <message>
        <source>%1 was cancelled; no file is left.</source>
        <translation>%1 a été annulé ; il ne reste aucun fichier.</translation>
    </message>
    <message>
        <source>%1 was changed by something else since this console read it. Do it again to overwrite that</source>
        <translation>%1 a été changé par autre chose depuis que cette console l'a lu. Recommencer pour écraser cela</translation>
    </message>
    <message>
        <source>%1 · %2 left out</source>
        <translation>%1 · %2 écartés</translation>
    </message>
    <message>
        <source>%1 · %2 min left</source>
        <translation>%1 · encore %2 min</translation>
    </message>
    <message>
        <source>%1 · coarser while it moves</source>
        <translation>%1 · moins fin en mouvement</translation>
    </message>
    <message>
        <source>%1 · less than 1 min left</source>
        <translation>%1 · moins de 1 min</translation>
    </message>
    <message>
        <source>%1 · too large: %2</source>
        <translation>%1 · trop grand : %2</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>%1 × %2 px at %3, %4</source>
        <translation>%1 × %2 px en %3, %4</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, %2 ×, %3. A gesture card is made of a touch in Review.</source>
        <translation>%1, %2 ×, %3. Une carte de geste se fait d'un toucher dans Relecture.</translation>
    </message>
    <message>
        <source>%1, in review</source>
        <translation>%1, en relecture</translation>
    </message>
    <message>
        <source>%1, in the unit beside</source>
        <translation>%1, dans l'unité à côté</translation>
    </message>
    <message>
        <source>%1: "%2" is no number.</source>
        <translation>%1 : « %2 » n'est pas un nombre.</translation>
    </message>
    <message>
        <source>%1: "%2" was not taken. Expected %3.</source>
        <translation>%1 : « %2 » refusé. Attendu %3.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>%1: %2 %</source>
        <translation>%1 : %2 %</translation>
    </message>
    <message>
        <source>%1: %2 is out of range; expected %3 to %4 %5.</source>
        <translation>%1 : %2 est hors limites ; attendu de %3 à %4 %5.</translation>
    </message>
    <message>
        <source>%1: %2 samples are saved, %3 could not be read. The damaged original is kept as %4.</source>
        <translation>%1 : %2 échantillons sauvés, %3 illisibles. L'original endommagé est conservé sous %4.</translation>
    </message>
    <message>
        <source>%1: %2 ± %3</source>
        <translation>%1 : %2 ± %3</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1 : %2.</translation>
    </message>
    <message>
        <source>%1: all %2 samples are saved, but not all that belongs to them: %3 could not be read. The damaged original is kept as %4.</source>
        <translation>%1 : les %2 échantillons sont tous sauvés, mais pas tout ce qui les accompagne : %3 illisible. L'original endommagé est conservé sous %4.</translation>
    </message>
    <message>
        <source>%1: choose the file</source>
        <translation>%1 : choisir le fichier</translation>
    </message>
    <message>
        <source>%1: difference %2, mean %3</source>
        <translation>%1 : différence %2, moyenne %3</translation>
    </message>
    <message>
        <source>%1: done</source>
        <translation>%1 : fait</translation>
    </message>
    <message>
        <source>%1: expected %2 to %3 s</source>
        <translation>%1 : de %2 à %3 s attendues</translation>
    </message>
    <message>
        <source>%1: expected a number from %2 to %3</source>
        <translation>%1 : un nombre de %2 à %3 est attendu</translation>
    </message>
    <message>
        <source>%1: now</source>
        <translation>%1 : maintenant</translation>
    </message>
    <message>
        <source>%1: this folder cannot be made</source>
        <translation>%1 : ce dossier ne peut pas être créé</translation>
    </message>
    <message>
        <source>%1: type a number first.</source>
        <translation>%1 : saisir d'abord un nombre.</translation>
    </message>
    <message>
        <source>%1; now %2</source>
        <translation>%1 ; maintenant %2</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) lost</source>
        <translation><numerusform>%n échantillon perdu</numerusform><numerusform>%n échantillons perdus</numerusform></translation>
    </message>
    <message>
        <source>'%1' is no time; expected seconds, such as 83.5, or minutes and seconds, such as 1:23.5.</source>
        <translation>« %1 » n'est pas un temps ; attendu : des secondes, comme 83,5, ou des minutes et secondes, comme 1:23,5.</translation>
    </message>
    <message>
        <source>'{}' is no parameter of this program's step</source>
        <translation>'{}' n'est pas un paramètre du pas de ce programme</translation>
    </message>
    <message>
        <source>'{}' is not a picture that can be read</source>
        <translation>'{}' n'est pas une image lisible</translation>
    </message>
    <message>
        <source>'{}' is not a picture that can be read: {}</source>
        <translation>'{}' n'est pas une image lisible : {}</translation>
    </message>
    <message>
        <source>'{}': expected [[record]]</source>
        <translation>'{}' : attendu [[record]]</translation>
    </message>
    <message>
        <source>'{}': expected a date such as 2026-11-21</source>
        <translation>'{}' : attendu une date comme 2026-11-21</translation>
    </message>
    <message>
        <source>'{}': expected a serial number of 1 to {} characters behind serial=</source>
        <translation>'{}' : attendu un numéro de série de 1 à {} caractères après serial=</translation>
    </message>
    <message>
        <source>'{}': expected id=SERIAL, as it stands in {}</source>
        <translation>'{}' : attendu id=SERIAL, comme il figure dans {}</translation>
    </message>
    <message>
        <source>'{}': expected id=value</source>
        <translation>'{}' : attendu id=value</translation>
    </message>
    <message>
        <source>'{}': expected modbus-tcp:HOST:PORT or modbus-rtu:TTY[:BAUD]</source>
        <translation>'{}' : attendu modbus-tcp:HOST:PORT ou modbus-rtu:TTY[:BAUD]</translation>
    </message>
    <message>
        <source>, shuffled and deflated</source>
        <translation>, mélangées et compressées</translation>
    </message>
    <message>
        <source>--after {}: expected a number of seconds from 0 to 3600</source>
        <translation>--after {} : attendu un nombre de secondes de 0 à 3600</translation>
    </message>
    <message>
        <source>--catalogue: {}</source>
        <translation>--catalogue : {}</translation>
    </message>
    <message>
        <source>--language {}: expected one of {}</source>
        <translation>--language {} : attendu l'une de {}</translation>
    </message>
    <message>
        <source>--open {}: expected one or more of {}</source>
        <translation>--open {} : attendu un ou plusieurs parmi {}</translation>
    </message>
    <message>
        <source>--operator, --subject, --notes and --tag describe a recording; add --record FILE</source>
        <translation>--operator, --subject, --notes et --tag décrivent un enregistrement ; ajouter --record FILE</translation>
    </message>
    <message>
        <source>--page {}: expected one of {}</source>
        <translation>--page {} : attendu l'une de {}</translation>
    </message>
    <message>
        <source>--review {}: no such file, or it may not be read</source>
        <translation>--review {} : ce fichier n'existe pas, ou ne peut pas être lu</translation>
    </message>
    <message>
        <source>--scale {}: expected a number from 0.5 to 4</source>
        <translation>--scale {} : attendu un nombre de 0,5 à 4</translation>
    </message>
    <message>
        <source>--simulate contradicts --touchpad {}</source>
        <translation>--simulate contredit --touchpad {}</translation>
    </message>
    <message>
        <source>--size {}: expected WIDTHxHEIGHT, each from {} to {}</source>
        <translation>--size {} : attendu LARGEURxHAUTEUR, chacune de {} à {}</translation>
    </message>
    <message>
        <source>--theme {}: expected dark, light or system</source>
        <translation>--theme {} : attendu dark, light ou system</translation>
    </message>
    <message>
        <source>--trials: {}</source>
        <translation>--trials : {}</translation>
    </message>
    <message>
        <source>--{} {}: expected a whole number from {} to {}</source>
        <translation>--{} {} : attendu un nombre entier de {} à {}</translation>
    </message>
    <message>
        <source>--{}: only with --trials</source>
        <translation>--{} : seulement avec --trials</translation>
    </message>
    <message>
        <source>/commits: row {} counts backwards</source>
        <translation>/commits : la ligne {} compte à rebours</translation>
    </message>
    <message>
        <source>/commits: row {} is damaged</source>
        <translation>/commits : la ligne {} est endommagée</translation>
    </message>
    <message>
        <source>/commits: {} of {} rows are damaged, the first: row {}</source>
        <translation>/commits : {} lignes sur {} sont endommagées, la première : ligne {}</translation>
    </message>
    <message>
        <source>0 s</source>
        <translation>0 s</translation>
    </message>
    <message>
        <source>1 kHz · %1 % missed</source>
        <translation>1 kHz · %1 % manqués</translation>
    </message>
    <message>
        <source>1 kHz · waits for this computer</source>
        <translation>1 kHz · attend cet ordinateur</translation>
    </message>
    <message>
        <source>: no. </source>
        <translation> : non. </translation>
    </message>
    <message>
        <source>: yes</source>
        <translation> : oui</translation>
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
        <translation>Glisser dans l’image déplace le point haptique au lieu de tourner la scène ; molette ou Maj : plus près ou plus loin. Sans ce bouton : Ctrl et glisser.</translation>
    </message>
    <message>
        <source>A held button moves the motors: %1.</source>
        <translation>Un bouton maintenu fait tourner les moteurs : %1.</translation>
    </message>
    <message>
        <source>A motor goes 2° out and back; the vibration lasts half a second.</source>
        <translation>Un moteur avance de 2° et revient ; la vibration dure une demi-seconde.</translation>
    </message>
    <message>
        <source>A note into the recording</source>
        <translation>Une note dans l'enregistrement</translation>
    </message>
    <message>
        <source>A note needs words.</source>
        <translation>La note est vide.</translation>
    </message>
    <message>
        <source>A note; Enter puts it into the recording</source>
        <translation>Une note ; Entrée la met dans l'enregistrement</translation>
    </message>
    <message>
        <source>A recording is beginning or ending. Wait until the disk has answered.</source>
        <translation>Un enregistrement commence ou se termine. Attendre que le disque ait répondu.</translation>
    </message>
    <message>
        <source>A recording is being recovered already; wait, or cancel it.</source>
        <translation>Une récupération est déjà en cours ; attendre ou l'annuler.</translation>
    </message>
    <message>
        <source>A recording is under way and would end. End it first.</source>
        <translation>Un enregistrement est en cours et finirait. Y mettre fin d’abord.</translation>
    </message>
    <message>
        <source>A rectangle around the cloth, with a finger in it.</source>
        <translation>Un rectangle autour du tissu, avec un doigt dedans.</translation>
    </message>
    <message>
        <source>A small file beside the recording, which the simulated finger plays (G)</source>
        <translation>Un petit fichier à côté de l'enregistrement, que le doigt simulé joue (G)</translation>
    </message>
    <message>
        <source>A test needs motors that answer.</source>
        <translation>Un essai demande des moteurs qui répondent.</translation>
    </message>
    <message>
        <source>A – B</source>
        <translation>A – B</translation>
    </message>
    <message>
        <source>A: feel the saved values</source>
        <translation>A : sentir les valeurs enregistrées</translation>
    </message>
    <message>
        <source>A: feel the saved values. Nothing can be changed meanwhile (Ctrl+B)</source>
        <translation>A : sentir les valeurs enregistrées. Rien ne peut être changé pendant ce temps (Ctrl+B)</translation>
    </message>
    <message>
        <source>A: saved</source>
        <translation>A : enregistré</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Accélération</translation>
    </message>
    <message>
        <source>Acceleration %1</source>
        <translation>Accélération %1</translation>
    </message>
    <message>
        <source>Acceleration of the finger over that of the rollers, far below the resonance.</source>
        <translation>Accélération du doigt rapportée à celle des rouleaux, bien en dessous de la résonance.</translation>
    </message>
    <message>
        <source>Acceleration, x</source>
        <translation>Accélération, x</translation>
    </message>
    <message>
        <source>Acceleration, y</source>
        <translation>Accélération, y</translation>
    </message>
    <message>
        <source>Acceleration, z</source>
        <translation>Accélération, z</translation>
    </message>
    <message>
        <source>Accelerations further apart than this are a gap, during which the texture is silent.</source>
        <translation>Des accélérations plus espacées que cela sont une lacune, pendant laquelle la texture se tait.</translation>
    </message>
    <message>
        <source>Accelerometer at rest</source>
        <translation>Accéléromètre au repos</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Accepter</translation>
    </message>
    <message>
        <source>Accept the calibration</source>
        <translation>Accepter l'étalonnage</translation>
    </message>
    <message>
        <source>Accept the proposed values</source>
        <translation>Accepter les valeurs proposées</translation>
    </message>
    <message>
        <source>Accepted and noted beside %1. It changes no value.</source>
        <translation>Accepté et noté à côté de %1. Aucune valeur ne change.</translation>
    </message>
    <message>
        <source>Accepted and written to %1, but the session goes on without it: %2. Start the window again to use it.</source>
        <translation>Accepté et écrit dans %1, mais la session continue sans : %2. Redémarrer la fenêtre pour l'utiliser.</translation>
    </message>
    <message>
        <source>Accepted and written to %1, but the session is closed: %2. Choose devices under Devices.</source>
        <translation>Accepté et écrit dans %1, mais la session est fermée : %2. Choisir des appareils sous Appareils.</translation>
    </message>
    <message>
        <source>Accepted and written to %1. The session has begun anew with it; motors stay off until you arm.</source>
        <translation>Accepté et écrit dans %1. La session a recommencé avec ; les moteurs restent coupés jusqu'à l'armement.</translation>
    </message>
    <message>
        <source>Accepted. The values are in force and in the profile.</source>
        <translation>Accepté. Les valeurs sont en vigueur et dans le profil.</translation>
    </message>
    <message>
        <source>Accepted. The values are in the profile, not in force.</source>
        <translation>Accepté. Les valeurs sont dans le profil, pas en vigueur.</translation>
    </message>
    <message>
        <source>Accepted: the proposed values are in use. Undo takes them back, Save profile keeps them.</source>
        <translation>Accepté : les valeurs proposées sont en usage. Annuler les retire, Enregistrer le profil les garde.</translation>
    </message>
    <message>
        <source>Accepting begins the session anew and would end the recording: stop the recording first.</source>
        <translation>Accepter recommence la session et mettrait fin à l'enregistrement : arrêter d'abord l'enregistrement.</translation>
    </message>
    <message>
        <source>Accepting begins the session anew, and that is not done while motors can move: press Esc first.</source>
        <translation>Accepter recommence la session, ce qui ne se fait pas tant que les moteurs peuvent bouger : appuyer d'abord sur Esc.</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Actif</translation>
    </message>
    <message>
        <source>Adaptive mode: a finger is darker than the lit cloth by at least this part of it.</source>
        <translation>Mode adaptive : un doigt est plus sombre que le tissu éclairé d'au moins cette fraction.</translation>
    </message>
    <message>
        <source>Adaptive mode: smallest dark area that counts as a touch, on the cloth.</source>
        <translation>Mode adaptive : plus petite aire sombre qui compte comme un toucher, sur le tissu.</translation>
    </message>
    <message>
        <source>Adaptive mode: use every n-th pixel and row, for slow computers.</source>
        <translation>Mode adaptive : n'utilise qu'un pixel et une ligne sur n, pour les ordinateurs lents.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Address already in use</source>
        <translation>l'adresse est déjà utilisée</translation>
    </message>
    <message>
        <source>Address and port to listen on</source>
        <translation>Adresse et port d'écoute</translation>
    </message>
    <message>
        <source>Advance from a frame to the next: whole frames are blocks, less overlaps them.</source>
        <translation>Avance d'une trame à la suivante : une trame entière donne des blocs, moins les recouvre.</translation>
    </message>
    <message>
        <source>Again and again</source>
        <translation>En boucle</translation>
    </message>
    <message>
        <source>Age of inputs</source>
        <translation>Âge des entrées</translation>
    </message>
    <message>
        <source>Align the other session at</source>
        <translation>Aligner l'autre session à</translation>
    </message>
    <message>
        <source>Align this session at</source>
        <translation>Aligner cette session à</translation>
    </message>
    <message>
        <source>All %1 trials are done.</source>
        <translation>Les %1 essais sont tous faits.</translation>
    </message>
    <message>
        <source>All back to saved</source>
        <translation>Tout ramener</translation>
    </message>
    <message>
        <source>All live parameters</source>
        <translation>Tous les paramètres en direct</translation>
    </message>
    <message>
        <source>All values back to saved</source>
        <translation>Toutes les valeurs : retour aux valeurs enregistrées</translation>
    </message>
    <message>
        <source>Amplitude over frequency, Hz</source>
        <translation>Amplitude en fréquence, Hz</translation>
    </message>
    <message>
        <source>Amplitude, %1</source>
        <translation>Amplitude, %1</translation>
    </message>
    <message>
        <source>An indentation less certain than this is unavailable.</source>
        <translation>Une indentation moins certaine que cela est indisponible.</translation>
    </message>
    <message>
        <source>Another program drives the touchpad</source>
        <translation>Un autre programme commande le touchpad</translation>
    </message>
    <message>
        <source>Another program has the motor board</source>
        <translation>Un autre programme utilise la carte moteurs</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Réponses</translation>
    </message>
    <message>
        <source>Any recording's file (Ctrl+O); it can be dropped onto the window, too</source>
        <translation>Le fichier d'un enregistrement quelconque (Ctrl+O) ; on peut aussi le déposer sur la fenêtre</translation>
    </message>
    <message>
        <source>Apply anyway</source>
        <translation>Appliquer quand même</translation>
    </message>
    <message>
        <source>Area, mm²</source>
        <translation>Aire, mm²</translation>
    </message>
    <message>
        <source>Arm: go to the button that is held</source>
        <translation>Armer : aller au bouton à maintenir</translation>
    </message>
    <message>
        <source>Arrived</source>
        <translation>Arrivé</translation>
    </message>
    <message>
        <source>As spring, but softer where the cloth would give back more than the finger put in.</source>
        <translation>Comme spring, mais plus souple là où le tissu rendrait plus que le doigt n'a apporté.</translation>
    </message>
    <message>
        <source>Asked</source>
        <translation>Demandé</translation>
    </message>
    <message>
        <source>Asking the devices whether they answer …</source>
        <translation>On demande aux appareils s’ils répondent …</translation>
    </message>
    <message>
        <source>Asking the devices whether they answer. The present session goes on meanwhile.</source>
        <translation>On demande aux appareils s’ils répondent. La session actuelle continue pendant ce temps.</translation>
    </message>
    <message>
        <source>At A</source>
        <translation>En A</translation>
    </message>
    <message>
        <source>At B</source>
        <translation>En B</translation>
    </message>
    <message>
        <source>At least %1 different distances that span %2 mm.</source>
        <translation>Au moins %1 distances différentes couvrant %2 mm.</translation>
    </message>
    <message>
        <source>At least %1 different weights that span %2 N.</source>
        <translation>Au moins %1 poids différents couvrant %2 N.</translation>
    </message>
    <message>
        <source>At least %1 places, not on one line.</source>
        <translation>Au moins %1 positions, pas sur une droite.</translation>
    </message>
    <message>
        <source>Auto-tune</source>
        <translation>Réglage automatique</translation>
    </message>
    <message>
        <source>Averages the signal and adds it to the points.</source>
        <translation>Fait la moyenne du signal et l'ajoute aux points.</translation>
    </message>
    <message>
        <source>Averaging</source>
        <translation>Moyennage</translation>
    </message>
    <message>
        <source>Averaging for %1 s: keep still.</source>
        <translation>Moyenne pendant %1 s : ne pas bouger.</translation>
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
        <translation>B : actuel</translation>
    </message>
    <message>
        <source>B: feel the current values</source>
        <translation>B : sentir les valeurs actuelles</translation>
    </message>
    <message>
        <source>B: feel the current values (Ctrl+B)</source>
        <translation>B : sentir les valeurs actuelles (Ctrl+B)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>Back to saved</source>
        <translation>Ramener au profil</translation>
    </message>
    <message>
        <source>Back to the default, %1</source>
        <translation>Revenir à la valeur par défaut, %1</translation>
    </message>
    <message>
        <source>Back to the saved value of %1</source>
        <translation>Retour à la valeur enregistrée de %1</translation>
    </message>
    <message>
        <source>Back to the saved value, %1</source>
        <translation>Retour à la valeur enregistrée, %1</translation>
    </message>
    <message>
        <source>Bad file descriptor</source>
        <translation>descripteur de fichier non valable</translation>
    </message>
    <message>
        <source>Began, UTC</source>
        <translation>Début, UTC</translation>
    </message>
    <message>
        <source>Beside, mm</source>
        <translation>À côté, mm</translation>
    </message>
    <message>
        <source>Between A and B</source>
        <translation>Entre A et B</translation>
    </message>
    <message>
        <source>Bookmark at the cursor</source>
        <translation>Signet au curseur</translation>
    </message>
    <message>
        <source>Both ends: this range is kept. Both empty: it follows the values.</source>
        <translation>Les deux bornes : cette plage est gardée. Les deux vides : elle suit les valeurs.</translation>
    </message>
    <message>
        <source>Bridge</source>
        <translation>Pont</translation>
    </message>
    <message>
        <source>Bridge, mV/V</source>
        <translation>Pont, mV/V</translation>
    </message>
    <message>
        <source>Brightness, contrast, exposure</source>
        <translation>Luminosité, contraste, exposition</translation>
    </message>
    <message>
        <source>Broken pipe</source>
        <translation>tube rompu</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>À la main</translation>
    </message>
    <message>
        <source>CSV table</source>
        <translation>Tableau CSV</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Étalonnage</translation>
    </message>
    <message>
        <source>Calibrate (the simulation needs none)</source>
        <translation>Étalonnage (la simulation n’en a pas besoin)</translation>
    </message>
    <message>
        <source>Calibrate it again under Calibrate. It does not keep you from arming.</source>
        <translation>À refaire sous Étalonnage. Cela n'empêche pas d'armer.</translation>
    </message>
    <message>
        <source>Calibrate this one under Calibrate. It does not keep you from arming.</source>
        <translation>L'étalonner sous Étalonnage. Cela n'empêche pas d'armer.</translation>
    </message>
    <message>
        <source>Calibrate: %1 of %2 parts</source>
        <translation>Étalonnage : %1 parties sur %2</translation>
    </message>
    <message>
        <source>Calibrated on this touchpad</source>
        <translation>Étalonné sur ce touchpad</translation>
    </message>
    <message>
        <source>Calibration points read with the former values are discarded: take them again (%1).</source>
        <translation>Les points d'étalonnage lus avec les valeurs précédentes sont écartés : les reprendre (%1).</translation>
    </message>
    <message>
        <source>Calibration report as PDF</source>
        <translation>Rapport d'étalonnage en PDF</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Camera height</source>
        <translation>Hauteur de la caméra</translation>
    </message>
    <message>
        <source>Camera of this computer</source>
        <translation>Caméra de cet ordinateur</translation>
    </message>
    <message>
        <source>Camera panel</source>
        <translation>Panneau de la caméra</translation>
    </message>
    <message>
        <source>Camera picture</source>
        <translation>Image de la caméra</translation>
    </message>
    <message>
        <source>Camera picture: click a place, or move it with the arrow keys</source>
        <translation>Image de la caméra : cliquer un point, ou le déplacer avec les flèches</translation>
    </message>
    <message>
        <source>Camera sees</source>
        <translation>La caméra voit</translation>
    </message>
    <message>
        <source>Camera: region, threshold</source>
        <translation>Caméra : région, seuil</translation>
    </message>
    <message>
        <source>Camera: scale</source>
        <translation>Caméra : échelle</translation>
    </message>
    <message>
        <source>Can I trust the sensors?</source>
        <translation>Puis-je me fier aux capteurs ?</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Cancel auto-tune</source>
        <translation>Annuler le réglage automatique</translation>
    </message>
    <message>
        <source>Cancel the newest with %1</source>
        <translation>Annuler le plus récent avec %1</translation>
    </message>
    <message>
        <source>Cancel what is running</source>
        <translation>Annuler ce qui est en cours</translation>
    </message>
    <message>
        <source>Cancel: %1</source>
        <translation>Annuler : %1</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Annulé.</translation>
    </message>
    <message>
        <source>Cancelled; nothing was changed.</source>
        <translation>Annulé ; rien n'a été changé.</translation>
    </message>
    <message>
        <source>Cancelling: %1</source>
        <translation>Annulation : %1</translation>
    </message>
    <message>
        <source>Cannot allocate memory</source>
        <translation>mémoire insuffisante</translation>
    </message>
    <message>
        <source>Cannot assign requested address</source>
        <translation>l'adresse demandée ne peut pas être attribuée</translation>
    </message>
    <message>
        <source>Cartesian impedance</source>
        <translation>impédance cartésienne</translation>
    </message>
    <message>
        <source>Change the robot</source>
        <translation>Changer le robot</translation>
    </message>
    <message>
        <source>Change, mm</source>
        <translation>Variation, mm</translation>
    </message>
    <message>
        <source>Changed parameters; Enter takes one away</source>
        <translation>Paramètres changés ; Entrée en retire un</translation>
    </message>
    <message>
        <source>Changed, not saved</source>
        <translation>Changé, non enregistré</translation>
    </message>
    <message>
        <source>Changed; the profile has %1</source>
        <translation>Changé ; le profil a %1</translation>
    </message>
    <message>
        <source>Check light and lens cap.</source>
        <translation>Vérifier la lumière et le capuchon de l'objectif.</translation>
    </message>
    <message>
        <source>Check the cable of the camera %1, or choose another source.</source>
        <translation>Vérifier le câble de la caméra %1, ou choisir une autre source.</translation>
    </message>
    <message>
        <source>Check the camera's cable or choose another source.</source>
        <translation>Vérifier le câble de la caméra ou choisir une autre source.</translation>
    </message>
    <message>
        <source>Check the load cell's bridge and its cable.</source>
        <translation>Vérifier le pont de la cellule de charge et son câble.</translation>
    </message>
    <message>
        <source>Check the motor board's power and its serial cable at %1.</source>
        <translation>Vérifier l'alimentation de la carte moteurs et son câble série à %1.</translation>
    </message>
    <message>
        <source>Check the network and the robot's program.</source>
        <translation>Vérifier le réseau et le programme du robot.</translation>
    </message>
    <message>
        <source>Check the network cable and the robot's program; it is awaited at %1.</source>
        <translation>Vérifier le câble réseau et le programme du robot ; il est attendu à %1.</translation>
    </message>
    <message>
        <source>Check the network cable and what sends the pictures at %1.</source>
        <translation>Vérifier le câble réseau et ce qui envoie les images à %1.</translation>
    </message>
    <message>
        <source>Check the robot's force sensor and probe again.</source>
        <translation>Vérifier le capteur de force du robot et palper à nouveau.</translation>
    </message>
    <message>
        <source>Check the touchpad's power and cables.</source>
        <translation>Vérifier l'alimentation et les câbles du touchpad.</translation>
    </message>
    <message>
        <source>Check the touchpad's power and its cable.</source>
        <translation>Vérifier l'alimentation du touchpad et son câble.</translation>
    </message>
    <message>
        <source>Check the touchpad's power and its network cable to %1.</source>
        <translation>Vérifier l'alimentation du touchpad et son câble réseau vers %1.</translation>
    </message>
    <message>
        <source>Check the touchpad's power and its serial cable at %1.</source>
        <translation>Vérifier l'alimentation du touchpad et son câble série à %1.</translation>
    </message>
    <message>
        <source>Choice of curves</source>
        <translation>Choix des courbes</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Choisir un fichier…</translation>
    </message>
    <message>
        <source>Choose a second recording: its curves are drawn faint behind these. In the list of sessions, two can be chosen at once.</source>
        <translation>Choisir un second enregistrement : ses courbes sont tracées estompées derrière celles-ci. Dans la liste des sessions, on peut en choisir deux à la fois.</translation>
    </message>
    <message>
        <source>Choose a session, or write the path of a recording.</source>
        <translation>Choisir une session, ou saisir le chemin d'un enregistrement.</translation>
    </message>
    <message>
        <source>Choose a touch in the list first.</source>
        <translation>Choisir d'abord un toucher dans la liste.</translation>
    </message>
    <message>
        <source>Choose curves</source>
        <translation>Choisir les courbes</translation>
    </message>
    <message>
        <source>Choose others</source>
        <translation>En choisir d’autres</translation>
    </message>
    <message>
        <source>Choose the camera.</source>
        <translation>Choisir la caméra.</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Choisir le fichier</translation>
    </message>
    <message>
        <source>Choose the folder.</source>
        <translation>Choisir le dossier.</translation>
    </message>
    <message>
        <source>Choose the key file</source>
        <translation>Choisir le fichier de clé</translation>
    </message>
    <message>
        <source>Choose the key file that the robot has as well.</source>
        <translation>Choisir le fichier de clé que le robot possède aussi.</translation>
    </message>
    <message>
        <source>Choose the motor board's serial port.</source>
        <translation>Choisir le port série de la carte moteurs.</translation>
    </message>
    <message>
        <source>Choose the recording.</source>
        <translation>Choisir l’enregistrement.</translation>
    </message>
    <message>
        <source>Choose the robot's stiffness or set one by hand.</source>
        <translation>Choisir la raideur du robot ou en régler une à la main.</translation>
    </message>
    <message>
        <source>Choose the scene file</source>
        <translation>Choisir le fichier de la scène</translation>
    </message>
    <message>
        <source>Choose the scene file.</source>
        <translation>Choisir le fichier de la scène.</translation>
    </message>
    <message>
        <source>Choose the serial port; behind a colon its speed, 115 200 Bd without.</source>
        <translation>Choisir le port série ; après un deux-points sa vitesse, sans elle 115 200 Bd.</translation>
    </message>
    <message>
        <source>Choose the touchpad and its camera in Devices, then press Connect there.</source>
        <translation>Choisir le touchpad et sa caméra dans Appareils, puis y presser Connecter.</translation>
    </message>
    <message>
        <source>Choose the video file.</source>
        <translation>Choisir le fichier vidéo.</translation>
    </message>
    <message>
        <source>Choose them under Devices.</source>
        <translation>Les choisir sous Appareils.</translation>
    </message>
    <message>
        <source>Choose two sessions to compare, the second with Ctrl.</source>
        <translation>Choisir deux sessions à comparer, la seconde avec Ctrl.</translation>
    </message>
    <message>
        <source>Choose two sessions, the second with Ctrl: the later one is drawn faint behind the first.</source>
        <translation>Choisir deux sessions, la seconde avec Ctrl : la plus récente est tracée estompée derrière la première.</translation>
    </message>
    <message>
        <source>Classic (not secured)</source>
        <translation>Classique (non sécurisé)</translation>
    </message>
    <message>
        <source>Click for more.</source>
        <translation>Cliquer pour en savoir plus.</translation>
    </message>
    <message>
        <source>Click the next mark, type where it lies, and take the point: best at the cloth's corners and in its middle. Marks that you press down, with their depth, tell how high the camera is.</source>
        <translation>Cliquer la marque suivante, saisir où elle se trouve, et prendre le point : de préférence aux coins du tissu et en son milieu. Des marques enfoncées, avec leur profondeur, disent à quelle hauteur est la caméra.</translation>
    </message>
    <message>
        <source>Click to look there; drag with the right button to choose a stretch.</source>
        <translation>Cliquer pour regarder là ; glisser avec le bouton droit pour choisir un intervalle.</translation>
    </message>
    <message>
        <source>Close other programs on this machine.</source>
        <translation>Fermer les autres programmes sur cet ordinateur.</translation>
    </message>
    <message>
        <source>Close the camera's panel</source>
        <translation>Fermer le panneau de la caméra</translation>
    </message>
    <message>
        <source>Close the choice of curves</source>
        <translation>Fermer le choix des courbes</translation>
    </message>
    <message>
        <source>Close the link's panel</source>
        <translation>Fermer le panneau de la liaison</translation>
    </message>
    <message>
        <source>Close the log</source>
        <translation>Fermer le journal</translation>
    </message>
    <message>
        <source>Close the manual</source>
        <translation>Fermer le manuel</translation>
    </message>
    <message>
        <source>Close the readiness list</source>
        <translation>Fermer la liste de préparation</translation>
    </message>
    <message>
        <source>Close the recording's panel</source>
        <translation>Fermer le panneau de l'enregistrement</translation>
    </message>
    <message>
        <source>Close the scene's panel</source>
        <translation>Fermer le panneau de la scène</translation>
    </message>
    <message>
        <source>Close the tuning panel</source>
        <translation>Fermer le panneau de réglage</translation>
    </message>
    <message>
        <source>Close what has it at %1, such as another console; this one then takes it by itself.</source>
        <translation>Fermer ce qui l'utilise à %1, par exemple une autre console ; celle-ci le reprend ensuite d'elle-même.</translation>
    </message>
    <message>
        <source>Close: %1</source>
        <translation>Fermer : %1</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Fermé</translation>
    </message>
    <message>
        <source>Closed loop: motors and cloth answer as identified from this recording.</source>
        <translation>Boucle fermée : moteurs et tissu répondent comme identifiés dans cet enregistrement.</translation>
    </message>
    <message>
        <source>Closed: the robot has said goodbye</source>
        <translation>Fermée : le robot a pris congé</translation>
    </message>
    <message>
        <source>Cloth</source>
        <translation>Tissu</translation>
    </message>
    <message>
        <source>Cloth %1 times its law's stiffness; sensors %2 s late with a lag of %3 s, noise %4 %. The courses above show what the proposal would do. Nothing is changed yet.</source>
        <translation>Tissu à %1 fois la raideur de sa loi ; capteurs en retard de %2 s, constante de temps %3 s, bruit %4 %. Les courbes ci-dessus montrent ce que ferait la proposition. Rien n'est encore changé.</translation>
    </message>
    <message>
        <source>Cloth edges</source>
        <translation>Bords du tissu</translation>
    </message>
    <message>
        <source>Cloth tension ratio</source>
        <translation>Rapport de tension du tissu</translation>
    </message>
    <message>
        <source>Coefficient</source>
        <translation>Coefficient</translation>
    </message>
    <message>
        <source>Commanded, °</source>
        <translation>Commandé, °</translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation>Commandes trouvées</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Compare the two</source>
        <translation>Comparer les deux</translation>
    </message>
    <message>
        <source>Compare the two chosen sessions</source>
        <translation>Comparer les deux sessions choisies</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Conditions</translation>
    </message>
    <message>
        <source>Conditions: light, temperature, target</source>
        <translation>Conditions : lumière, température, cible</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Connecter</translation>
    </message>
    <message>
        <source>Connect devices</source>
        <translation>Connecter les appareils</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Connecté</translation>
    </message>
    <message>
        <source>Connected: %1.</source>
        <translation>Connecté : %1.</translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation>connexion refusée</translation>
    </message>
    <message>
        <source>Connection reset by peer</source>
        <translation>connexion réinitialisée par l'autre côté</translation>
    </message>
    <message>
        <source>Connection timed out</source>
        <translation>délai de connexion dépassé</translation>
    </message>
    <message>
        <source>Contact mode: from the camera's lens to the untouched cloth.</source>
        <translation>Mode contact : de l'objectif de la caméra au tissu non touché.</translation>
    </message>
    <message>
        <source>Contact mode: held on all four sides, or held by two rollers left and right with front and back free.</source>
        <translation>Mode contact : tenu sur les quatre côtés, ou tenu par deux rouleaux à gauche et à droite, l'avant et l'arrière libres.</translation>
    </message>
    <message>
        <source>Contact mode: how uncertain that ratio is, as a part of it.</source>
        <translation>Mode contact : incertitude de ce rapport, en part de celui-ci.</translation>
    </message>
    <message>
        <source>Contact mode: how uncertain that share is.</source>
        <translation>Mode contact : incertitude de cette part.</translation>
    </message>
    <message>
        <source>Contact mode: radius of the disc that the finger looks like from afar, as a share of the contact's: 0.6 for a sphere, 1 for a flat disc.</source>
        <translation>Mode contact : rayon du disque que le doigt paraît être de loin, en part de celui du contact : 0,6 pour une sphère, 1 pour un disque plat.</translation>
    </message>
    <message>
        <source>Contact mode: the cloth's tension from left to right over that from front to back.</source>
        <translation>Mode contact : tension du tissu de gauche à droite divisée par celle d'avant en arrière.</translation>
    </message>
    <message>
        <source>Contact mode: what the cloth's formula leaves of each sensor's share, as a part of the indentation.</source>
        <translation>Mode contact : ce que la formule du tissu laisse dans la part de chaque capteur, en part de l'indentation.</translation>
    </message>
    <message>
        <source>Contact radius share</source>
        <translation>Part du rayon de contact</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Sommaire</translation>
    </message>
    <message>
        <source>Controls</source>
        <translation>Commandes</translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation>Copier le chemin</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Coupure</translation>
    </message>
    <message>
        <source>Corner (-3 dB) of the default high-pass.</source>
        <translation>Fréquence de coupure (-3 dB) du passe-haut par défaut.</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Correction</translation>
    </message>
    <message>
        <source>Correction limit</source>
        <translation>Limite de correction</translation>
    </message>
    <message>
        <source>Coupling</source>
        <translation>Couplage</translation>
    </message>
    <message>
        <source>Crossfade</source>
        <translation>Fondu</translation>
    </message>
    <message>
        <source>Cursor</source>
        <translation>Curseur</translation>
    </message>
    <message>
        <source>Cursor back by a hundredth</source>
        <translation>Reculer le curseur d'un centième</translation>
    </message>
    <message>
        <source>Cursor on by a hundredth</source>
        <translation>Avancer le curseur d'un centième</translation>
    </message>
    <message>
        <source>Cursor to the next sample</source>
        <translation>Curseur à l'échantillon suivant</translation>
    </message>
    <message>
        <source>Cursor to the previous sample</source>
        <translation>Curseur à l'échantillon précédent</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>Cycles missed</source>
        <translation>Cycles manqués</translation>
    </message>
    <message>
        <source>Damping ratio of that resonance.</source>
        <translation>Taux d'amortissement de cette résonance.</translation>
    </message>
    <message>
        <source>Dark theme</source>
        <translation>Thème sombre</translation>
    </message>
    <message>
        <source>Dead band</source>
        <translation>Bande morte</translation>
    </message>
    <message>
        <source>Dead time of the measured stiffness behind the stretch; auto-tune measures it.</source>
        <translation>Temps mort de la raideur mesurée par rapport à l'étirement ; le réglage automatique le mesure.</translation>
    </message>
    <message>
        <source>Dead zone</source>
        <translation>Zone morte</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Delete the chosen preset</source>
        <translation>Supprimer le préréglage choisi</translation>
    </message>
    <message>
        <source>Delete the chosen preset; undo brings it back</source>
        <translation>Supprimer le préréglage choisi ; Annuler le ramène</translation>
    </message>
    <message>
        <source>Demonstration</source>
        <translation>Démonstration</translation>
    </message>
    <message>
        <source>Demonstration by the simulated finger</source>
        <translation>Démonstration par le doigt simulé</translation>
    </message>
    <message>
        <source>Depth
mm</source>
        <translation>Profondeur
mm</translation>
    </message>
    <message>
        <source>Depth at the sensor under the finger, mm</source>
        <translation>Profondeur au capteur sous le doigt, mm</translation>
    </message>
    <message>
        <source>Depth there, mm</source>
        <translation>Profondeur là, mm</translation>
    </message>
    <message>
        <source>Depth, mm</source>
        <translation>Profondeur, mm</translation>
    </message>
    <message>
        <source>Derivative filter</source>
        <translation>Filtre du dérivé</translation>
    </message>
    <message>
        <source>Derivative gain in thesis mode (the thesis used none).</source>
        <translation>Gain dérivé en mode thesis (la thèse n'en utilisait pas).</translation>
    </message>
    <message>
        <source>Derivative gain, on the measured stiffness and not on the target.</source>
        <translation>Gain dérivé, sur la raideur mesurée et non sur la consigne.</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>appareil ou ressource occupés</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Appareils</translation>
    </message>
    <message>
        <source>Devices can be changed only while nothing can move. Press Esc first.</source>
        <translation>Les appareils ne peuvent être changés que tant que rien ne peut bouger. Presser d’abord Esc.</translation>
    </message>
    <message>
        <source>Devices not found</source>
        <translation>Appareils introuvables</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Différences</translation>
    </message>
    <message>
        <source>Differences, presets, auto-tune, read back</source>
        <translation>Différences, préréglages, réglage automatique, relu</translation>
    </message>
    <message>
        <source>Different from %1 s on (%2).</source>
        <translation>Différent à partir de %1 s (%2).</translation>
    </message>
    <message>
        <source>Directory not empty</source>
        <translation>le dossier n'est pas vide</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Écarter</translation>
    </message>
    <message>
        <source>Discard the points</source>
        <translation>Écarter les points</translation>
    </message>
    <message>
        <source>Discard the proposed values</source>
        <translation>Écarter les valeurs proposées</translation>
    </message>
    <message>
        <source>Discarded; nothing was changed.</source>
        <translation>Écarté ; rien n'a été changé.</translation>
    </message>
    <message>
        <source>Disconnected</source>
        <translation>Déconnecté</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>quota du disque dépassé</translation>
    </message>
    <message>
        <source>Dismiss all notices</source>
        <translation>Fermer tous les avis</translation>
    </message>
    <message>
        <source>Dismiss: %1</source>
        <translation>Fermer : %1</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Distance %1</source>
        <translation>Distance %1</translation>
    </message>
    <message>
        <source>Distance sensor</source>
        <translation>Capteur de distance</translation>
    </message>
    <message>
        <source>Distance sensor {}</source>
        <translation>Capteur de distance {}</translation>
    </message>
    <message>
        <source>Distance sensor's curve of volts, as its form says; empty: the thesis polynomial.</source>
        <translation>Courbe du capteur de distance en fonction des volts, selon sa forme ; vide : le polynôme de la thèse.</translation>
    </message>
    <message>
        <source>Distance sensors measure</source>
        <translation>Les capteurs de distance mesurent</translation>
    </message>
    <message>
        <source>Distance sensors: distance to the untouched cloth; the tare sets it.</source>
        <translation>Capteurs de distance : distance au tissu non touché ; fixée par la tare.</translation>
    </message>
    <message>
        <source>Distance sensors: highest valid ADC code of each.</source>
        <translation>Capteurs de distance : code CAN valable le plus haut de chacun.</translation>
    </message>
    <message>
        <source>Distance sensors: lowest valid ADC code of each.</source>
        <translation>Capteurs de distance : code CAN valable le plus bas de chacun.</translation>
    </message>
    <message>
        <source>Distance sensors: noise of one reading.</source>
        <translation>Capteurs de distance : bruit d'une lecture.</translation>
    </message>
    <message>
        <source>Distance sensors: x of each; as many as there are.</source>
        <translation>Capteurs de distance : x de chacun ; autant qu'il y en a.</translation>
    </message>
    <message>
        <source>Distance sensors: y of each.</source>
        <translation>Capteurs de distance : y de chacun.</translation>
    </message>
    <message>
        <source>Distance, mm</source>
        <translation>Distance, mm</translation>
    </message>
    <message>
        <source>Distances, mm</source>
        <translation>Distances, mm</translation>
    </message>
    <message>
        <source>Dots: both encoders with the new zero and sign. Line: where the motors were sent. Dashed: the first encoder as it is read now.</source>
        <translation>Points : les deux codeurs avec leurs nouveaux zéro et signe. Trait : la position demandée aux moteurs. Tirets : le premier codeur tel qu'il est lu à présent.</translation>
    </message>
    <message>
        <source>Dots: each press, what the sensors beside the finger read of it. Below, how far the fit is off there.</source>
        <translation>Points : chaque appui, ce qu'en lisent les capteurs à côté du doigt. Dessous, de combien l'ajustement s'y trompe.</translation>
    </message>
    <message>
        <source>Dots: each press. Bars: an angle's stiffness with its 95 % interval. Line: the new law. Dashed: the one in force. Crosses: presses the others contradict.</source>
        <translation>Points : chaque pression. Barres : raideur d'un angle et son intervalle à 95 %. Trait : la nouvelle loi. Tirets : celle en vigueur. Croix : pressions que les autres contredisent.</translation>
    </message>
    <message>
        <source>Dots: length of each reading. Line: their mean. Dashed: what is expected.</source>
        <translation>Points : norme de chaque lecture. Trait : leur moyenne. Tirets : la valeur attendue.</translation>
    </message>
    <message>
        <source>Dots: measured. Dashed: the offsets in force.</source>
        <translation>Points : mesurés. Tirets : les décalages en vigueur.</translation>
    </message>
    <message>
        <source>Dots: the resonance at each stretch, with its uncertainty. Line: what the texture will reckon with. Dashed: what it reckons with now.</source>
        <translation>Points : la résonance à chaque étirement, avec son incertitude. Ligne : ce dont la texture tiendra compte. Pointillés : ce dont elle tient compte maintenant.</translation>
    </message>
    <message>
        <source>Drag to look back, wheel to zoom, drag with the right button to zoom into a box,
Ctrl and wheel to stretch this curve, double-click or F to follow again.</source>
        <translation>Glisser pour revenir en arrière, molette pour zoomer, glisser avec le bouton droit pour zoomer dans un cadre,
Ctrl et molette pour étirer cette courbe, double-clic ou F pour suivre à nouveau.</translation>
    </message>
    <message>
        <source>Drag to look elsewhere, wheel to zoom, drag with the right button to zoom into a box,
Ctrl and wheel to stretch this curve, double-click for the whole session.</source>
        <translation>Glisser pour regarder ailleurs, molette pour zoomer, glisser avec le bouton droit pour zoomer dans un cadre,
Ctrl et molette pour étirer cette courbe, double-clic pour toute la session.</translation>
    </message>
    <message>
        <source>Drag: touch · Shift or wheel: depth · right button: move</source>
        <translation>Glisser : toucher · Maj ou molette : profondeur · bouton droit : déplacer</translation>
    </message>
    <message>
        <source>Drag: turn · Shift: move · wheel: zoom</source>
        <translation>Glisser : tourner · Maj : déplacer · molette : zoomer</translation>
    </message>
    <message>
        <source>Drag: turn · Shift: move · wheel: zoom · Ctrl: touch</source>
        <translation>Glisser : tourner · Maj : déplacer · molette : zoom · Ctrl : toucher</translation>
    </message>
    <message>
        <source>Drawn faint. Choose a touch of each to lay one on the other.</source>
        <translation>Tracée estompée. Choisir un toucher de chacune pour les superposer.</translation>
    </message>
    <message>
        <source>Drawn faint. The search for its touches was cancelled.</source>
        <translation>Tracée estompée. La recherche de ses touchers a été annulée.</translation>
    </message>
    <message>
        <source>Duty that the first motor needs before it turns.</source>
        <translation>Rapport cyclique nécessaire au premier moteur pour tourner.</translation>
    </message>
    <message>
        <source>Duty that the second motor needs before it turns.</source>
        <translation>Rapport cyclique nécessaire au second moteur pour tourner.</translation>
    </message>
    <message>
        <source>Duty with which the board's own position loop answers a degree.</source>
        <translation>Rapport cyclique avec lequel la boucle de position de la carte répond à un degré.</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>Encoder 1</source>
        <translation>Codeur 1</translation>
    </message>
    <message>
        <source>Encoder 2</source>
        <translation>Codeur 2</translation>
    </message>
    <message>
        <source>Encoders: sign, zero, range</source>
        <translation>Codeurs : signe, zéro, plage</translation>
    </message>
    <message>
        <source>Energy of the touch</source>
        <translation>Énergie du contact</translation>
    </message>
    <message>
        <source>Enough points.</source>
        <translation>Assez de points.</translation>
    </message>
    <message>
        <source>Enter or a double click goes back to a layout.</source>
        <translation>Entrée ou un double-clic revient à une disposition.</translation>
    </message>
    <message>
        <source>Enter or a double click opens a session. Two chosen, the second with Ctrl, can be compared.</source>
        <translation>Entrée ou un double-clic ouvre une session. Deux choisies, la seconde avec Ctrl, peuvent être comparées.</translation>
    </message>
    <message>
        <source>Enter the address and port to listen on, such as 127.0.0.1:3490.</source>
        <translation>Saisir l'adresse et le port d'écoute, comme 127.0.0.1:3490.</translation>
    </message>
    <message>
        <source>Enter the stream's address, such as http://192.168.0.7:8090/.</source>
        <translation>Entrer l’adresse du flux, par exemple http://192.168.0.7:8090/.</translation>
    </message>
    <message>
        <source>Enter the touchpad's address and port, such as 192.168.0.7:502.</source>
        <translation>Entrer l’adresse et le port du touchpad, par exemple 192.168.0.7:502.</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Error beside, mm</source>
        <translation>Erreur à côté, mm</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>Erreur, mm</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Erreurs</translation>
    </message>
    <message>
        <source>Errors by kind</source>
        <translation>Erreurs par type</translation>
    </message>
    <message>
        <source>Errors of the stiffness up to this are left alone (the thesis, in its own mode, 0.01).</source>
        <translation>Les erreurs de raideur jusqu'à cette valeur sont laissées telles quelles (la thèse, dans son mode, 0,01).</translation>
    </message>
    <message>
        <source>Esc stops.</source>
        <translation>Esc arrête.</translation>
    </message>
    <message>
        <source>Every parameter takes its saved value again; one step to undo</source>
        <translation>Chaque paramètre reprend sa valeur enregistrée ; une seule étape à annuler</translation>
    </message>
    <message>
        <source>Everything is simulated: time waits for this computer when it is late, %1 s so far, and nothing is Held for it.</source>
        <translation>Tout est simulé : le temps attend cet ordinateur quand il est en retard, %1 s jusqu'ici, et rien n'est Bloqué pour cela.</translation>
    </message>
    <message>
        <source>Everything needed is there; motors off.</source>
        <translation>Tout le nécessaire est là ; moteurs coupés.</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Expérience</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>Exporter en CSV</translation>
    </message>
    <message>
        <source>Export as MCAP</source>
        <translation>Exporter en MCAP</translation>
    </message>
    <message>
        <source>Export for MATLAB</source>
        <translation>Exporter pour MATLAB</translation>
    </message>
    <message>
        <source>Export the camera's video</source>
        <translation>Exporter la vidéo de la caméra</translation>
    </message>
    <message>
        <source>Export, all or from A to B</source>
        <translation>Exporter, tout ou de A à B</translation>
    </message>
    <message>
        <source>FYD Console</source>
        <translation>FYD Console</translation>
    </message>
    <message>
        <source>FYD Link robot, listening on {}</source>
        <translation>robot FYD Link, en écoute sur {}</translation>
    </message>
    <message>
        <source>FYD Link with a key</source>
        <translation>FYD Link avec une clé</translation>
    </message>
    <message>
        <source>FYD Link, sealed</source>
        <translation>FYD Link, scellé</translation>
    </message>
    <message>
        <source>Fastest change of the commanded stretch and translation; in mode thesis not of the stretch, unless the robot sets it.</source>
        <translation>Vitesse maximale de l'étirement et de la translation commandés ; dans le mode thesis pas de l'étirement, sauf si le robot le donne.</translation>
    </message>
    <message>
        <source>Fastest the position sent to the robot moves along each axis.</source>
        <translation>Vitesse maximale, le long de chaque axe, de la position envoyée au robot.</translation>
    </message>
    <message>
        <source>Feel saved or current values</source>
        <translation>Sentir les valeurs enregistrées ou actuelles</translation>
    </message>
    <message>
        <source>Felt, over threshold</source>
        <translation>Senti, au-dessus du seuil</translation>
    </message>
    <message>
        <source>Figures between A and B</source>
        <translation>Valeurs entre A et B</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>File %1: expected a name that ends in .h5.</source>
        <translation>Fichier %1 : attendu un nom qui se termine par .h5.</translation>
    </message>
    <message>
        <source>File %1: expected a whole path, from / on.</source>
        <translation>Fichier %1 : attendu un chemin complet, à partir de /.</translation>
    </message>
    <message>
        <source>File %1: it is there already; a recording is never written over.</source>
        <translation>Fichier %1 : existe déjà ; un enregistrement n'est jamais écrasé.</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>le fichier existe déjà</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>nom de fichier trop long</translation>
    </message>
    <message>
        <source>File of the recording</source>
        <translation>Fichier de l'enregistrement</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>fichier trop grand</translation>
    </message>
    <message>
        <source>File: where is the recording to go?</source>
        <translation>Fichier : où mettre l'enregistrement ?</translation>
    </message>
    <message>
        <source>Files written</source>
        <translation>Fichiers écrits</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtre</translation>
    </message>
    <message>
        <source>Find a command</source>
        <translation>Trouver une commande</translation>
    </message>
    <message>
        <source>Find a command…</source>
        <translation>Trouver une commande…</translation>
    </message>
    <message>
        <source>Find a parameter…</source>
        <translation>Chercher un paramètre…</translation>
    </message>
    <message>
        <source>Finds out how cloth and sensors answer and proposes gains. Nothing changes until you accept.</source>
        <translation>Identifie comment répondent tissu et capteurs et propose des gains. Rien ne change avant l'acceptation.</translation>
    </message>
    <message>
        <source>Finger</source>
        <translation>Doigt</translation>
    </message>
    <message>
        <source>Finger area in square millimetres</source>
        <translation>Aire du doigt en millimètres carrés</translation>
    </message>
    <message>
        <source>Finger centre x</source>
        <translation>Centre x du doigt</translation>
    </message>
    <message>
        <source>Finger centre y</source>
        <translation>Centre y du doigt</translation>
    </message>
    <message>
        <source>Finger found</source>
        <translation>Doigt trouvé</translation>
    </message>
    <message>
        <source>Finger mask</source>
        <translation>Masque du doigt</translation>
    </message>
    <message>
        <source>Finger minimum area</source>
        <translation>Aire minimale du doigt</translation>
    </message>
    <message>
        <source>Finger minimum contrast</source>
        <translation>Contraste minimal du doigt</translation>
    </message>
    <message>
        <source>Finger mirror</source>
        <translation>Miroir du doigt</translation>
    </message>
    <message>
        <source>Finger mode</source>
        <translation>Mode du doigt</translation>
    </message>
    <message>
        <source>Finger rotation</source>
        <translation>Rotation du doigt</translation>
    </message>
    <message>
        <source>Finger scale x</source>
        <translation>Échelle x du doigt</translation>
    </message>
    <message>
        <source>Finger scale y</source>
        <translation>Échelle y du doigt</translation>
    </message>
    <message>
        <source>Finger smallest contact</source>
        <translation>Plus petit contact du doigt</translation>
    </message>
    <message>
        <source>Finger threshold</source>
        <translation>Seuil du doigt</translation>
    </message>
    <message>
        <source>Finger x in millimetres</source>
        <translation>x du doigt en millimètres</translation>
    </message>
    <message>
        <source>Finger y in millimetres</source>
        <translation>y du doigt en millimètres</translation>
    </message>
    <message>
        <source>Finger's area</source>
        <translation>Aire du doigt</translation>
    </message>
    <message>
        <source>Finger, indentation and force</source>
        <translation>Doigt, indentation et force</translation>
    </message>
    <message>
        <source>Finger, x</source>
        <translation>Doigt, x</translation>
    </message>
    <message>
        <source>Finger, y</source>
        <translation>Doigt, y</translation>
    </message>
    <message>
        <source>Finger: %1</source>
        <translation>Doigt : %1</translation>
    </message>
    <message>
        <source>First encoder's reading at zero stretch.</source>
        <translation>Lecture du premier codeur à étirement nul.</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Premiers pas</translation>
    </message>
    <message>
        <source>First touch</source>
        <translation>Premier toucher</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustement</translation>
    </message>
    <message>
        <source>Fitted</source>
        <translation>Ajusté</translation>
    </message>
    <message>
        <source>Folder of pictures</source>
        <translation>Dossier d’images</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Suivre</translation>
    </message>
    <message>
        <source>Follow the newest values</source>
        <translation>Suivre les valeurs les plus récentes</translation>
    </message>
    <message>
        <source>Follow the newest values (F)</source>
        <translation>Suivre les valeurs les plus récentes (F)</translation>
    </message>
    <message>
        <source>Follow the stiffness of what the robot touches.</source>
        <translation>Suit la raideur de ce que touche le robot.</translation>
    </message>
    <message>
        <source>Following</source>
        <translation>Suivi</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>Force
N</source>
        <translation>Force
N</translation>
    </message>
    <message>
        <source>Force %1</source>
        <translation>Force %1</translation>
    </message>
    <message>
        <source>Force noise</source>
        <translation>Bruit de la force</translation>
    </message>
    <message>
        <source>Force tare sigma</source>
        <translation>Sigma de tare de la force</translation>
    </message>
    <message>
        <source>Force the robot tells</source>
        <translation>Force que dit le robot</translation>
    </message>
    <message>
        <source>Force zero</source>
        <translation>Zéro de la force</translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation>Force, N</translation>
    </message>
    <message>
        <source>Forgets this part's points; the values in force stay.</source>
        <translation>Oublie les points de cette partie ; les valeurs en vigueur restent.</translation>
    </message>
    <message>
        <source>Format of the file</source>
        <translation>Format du fichier</translation>
    </message>
    <message>
        <source>Found in the manual</source>
        <translation>Trouvé dans le manuel</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Trame</translation>
    </message>
    <message>
        <source>Frequency over time, Hz over s</source>
        <translation>Fréquence dans le temps, Hz sur s</translation>
    </message>
    <message>
        <source>Frequency, Hz</source>
        <translation>Fréquence, Hz</translation>
    </message>
    <message>
        <source>From A to B: %1 s to %2 s</source>
        <translation>De A à B : de %1 s à %2 s</translation>
    </message>
    <message>
        <source>From A to B: a report is of the whole session</source>
        <translation>De A à B : un rapport porte sur toute la session</translation>
    </message>
    <message>
        <source>From A to B: set them with [ and ]</source>
        <translation>De A à B : les placer avec [ et ]</translation>
    </message>
    <message>
        <source>From the last minute of this session</source>
        <translation>De la dernière minute de cette session</translation>
    </message>
    <message>
        <source>From the mean, g</source>
        <translation>De la moyenne, g</translation>
    </message>
    <message>
        <source>From the simulated touchpad, 12 s of virtual time</source>
        <translation>Du touchpad simulé, 12 s de temps virtuel</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Full scale</source>
        <translation>Pleine échelle</translation>
    </message>
    <message>
        <source>Gain k_vib</source>
        <translation>Gain k_vib</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>Marge de gain</translation>
    </message>
    <message>
        <source>Gain of the vibration; the robot's operator moves it by 0.1.</source>
        <translation>Gain de la vibration ; l'opérateur du robot le change de 0,1.</translation>
    </message>
    <message>
        <source>Gesture card for the simulated finger</source>
        <translation>Carte de geste pour le doigt simulé</translation>
    </message>
    <message>
        <source>Gesture card or recorded hand</source>
        <translation>Carte de geste ou main enregistrée</translation>
    </message>
    <message>
        <source>Gesture card …</source>
        <translation>Carte de geste …</translation>
    </message>
    <message>
        <source>Gesture cards (*.gesture);;Recorded hands (*.csv);;All files (*)</source>
        <translation>Cartes de geste (*.gesture);;Mains enregistrées (*.csv);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Give the chosen preset the name above</source>
        <translation>Donner au préréglage choisi le nom ci-dessus</translation>
    </message>
    <message>
        <source>Go on to the heaviest weight, then take the same weights off again one by one.</source>
        <translation>Aller jusqu'au poids le plus lourd, puis retirer les mêmes poids un à un.</translation>
    </message>
    <message>
        <source>Go to Operate, hold Arm in the bar above until it acts, then press the cloth with a finger. Esc stops at any time.</source>
        <translation>Aller à Conduite, maintenir le bouton d’armement de la barre du haut jusqu’à ce qu’il agisse, puis presser le tissu du doigt. Esc arrête à tout moment.</translation>
    </message>
    <message>
        <source>Go to Operate, hold Arm in the bar above until it acts, then press the cloth: with the mouse on the camera's picture.</source>
        <translation>Aller à Conduite, maintenir le bouton d’armement de la barre du haut jusqu’à ce qu’il agisse, puis presser le tissu : à la souris sur l’image de la caméra.</translation>
    </message>
    <message>
        <source>Go to a time</source>
        <translation>Aller à un temps</translation>
    </message>
    <message>
        <source>Go to a time of the session</source>
        <translation>Aller à un temps de la session</translation>
    </message>
    <message>
        <source>Good: %1.</source>
        <translation>Bon : %1.</translation>
    </message>
    <message>
        <source>Greatest stretch the controller commands.</source>
        <translation>Plus grand étirement que le régulateur commande.</translation>
    </message>
    <message>
        <source>Grey value</source>
        <translation>Niveau de gris</translation>
    </message>
    <message>
        <source>HDF5 does not take the console's driver</source>
        <translation>HDF5 n'accepte pas le pilote de la console</translation>
    </message>
    <message>
        <source>Half a second without a hole is needed.</source>
        <translation>Il faut une demi-seconde sans trou.</translation>
    </message>
    <message>
        <source>Half the usable cloth's depth.</source>
        <translation>Moitié de la profondeur utile du tissu.</translation>
    </message>
    <message>
        <source>Half the usable cloth's width.</source>
        <translation>Moitié de la largeur utile du tissu.</translation>
    </message>
    <message>
        <source>Hand target</source>
        <translation>Consigne à la main</translation>
    </message>
    <message>
        <source>Haptic point</source>
        <translation>Point haptique</translation>
    </message>
    <message>
        <source>Haptic point %1, proxy %2, force %3; %4.</source>
        <translation>Point haptique %1, proxy %2, force %3 ; %4.</translation>
    </message>
    <message>
        <source>Heat limit</source>
        <translation>Limite thermique</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Height of the cloth in the camera's picture.</source>
        <translation>Hauteur du tissu dans l'image de la caméra.</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Bloqué</translation>
    </message>
    <message>
        <source>Held-out error %1</source>
        <translation>Erreur de vérification %1</translation>
    </message>
    <message>
        <source>Held-out error %1 of at most %2</source>
        <translation>Erreur de vérification %1 (au plus %2)</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Help for what is in focus</source>
        <translation>Aide sur l'élément actif</translation>
    </message>
    <message>
        <source>Here: %1
Robot: %2
%3 states received, %4 touches sent, %5 datagrams refused</source>
        <translation>Ici : %1
Robot : %2
%3 états reçus, %4 touchers envoyés, %5 datagrammes refusés</translation>
    </message>
    <message>
        <source>High-pass in front of the method; thesis is the printed one, with its leak of gravity.</source>
        <translation>Passe-haut avant la méthode ; thesis est celui qui est imprimé, avec sa fuite de gravité.</translation>
    </message>
    <message>
        <source>Hold Arm to start.</source>
        <translation>Maintenir Armer pour commencer.</translation>
    </message>
    <message>
        <source>Hold Re-arm to start again.</source>
        <translation>Maintenir Réarmer pour recommencer.</translation>
    </message>
    <message>
        <source>Hold a flat white target over the sensor, measure its distance, type it and take the point.</source>
        <translation>Tenir une cible blanche plane au-dessus du capteur, mesurer sa distance, la saisir et prendre le point.</translation>
    </message>
    <message>
        <source>Hold for 0.6 s, by mouse or with the space bar, to start rendering: the motors switch on.</source>
        <translation>Maintenir 0,6 s, à la souris ou avec la barre d'espace, pour commencer le rendu : les moteurs s'allument.</translation>
    </message>
    <message>
        <source>Hold still.</source>
        <translation>Ne pas bouger.</translation>
    </message>
    <message>
        <source>Hold the button until the sweep is done, then look at the fit and accept it.</source>
        <translation>Tenir le bouton jusqu'à la fin du balayage, puis regarder la courbe et l'accepter.</translation>
    </message>
    <message>
        <source>Hold the picture still; measuring goes on (Space)</source>
        <translation>Fige l'image ; la mesure continue (Espace)</translation>
    </message>
    <message>
        <source>Hold the space bar, or the mouse on the button, for 0.6 s to arm.</source>
        <translation>Pour armer, maintenir 0,6 s la barre d'espace, ou la souris sur le bouton.</translation>
    </message>
    <message>
        <source>Hold the stiffness set below, whatever the robot touches.</source>
        <translation>Maintient la raideur réglée ci-dessous, quoi que touche le robot.</translation>
    </message>
    <message>
        <source>Hold the vertical ranges</source>
        <translation>Figer les plages verticales</translation>
    </message>
    <message>
        <source>Hold to arm</source>
        <translation>Maintenir : armer</translation>
    </message>
    <message>
        <source>Hold to move</source>
        <translation>Tenir : bouger</translation>
    </message>
    <message>
        <source>Hold to move the motors</source>
        <translation>Tenir pour faire tourner les moteurs</translation>
    </message>
    <message>
        <source>Hold to re-arm</source>
        <translation>Maintenir : réarmer</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Départ</translation>
    </message>
    <message>
        <source>Hop</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>How far the time between the robot's messages strays: four mean deviations.</source>
        <translation>De combien varie le temps entre les messages du robot : quatre écarts moyens.</translation>
    </message>
    <message>
        <source>How fast the cloth's stiffness may wander while the motors move.</source>
        <translation>À quelle vitesse la raideur du tissu peut varier pendant que les moteurs bougent.</translation>
    </message>
    <message>
        <source>How long accelerations wait (plus up to one period), so that jittery packets still arrive in time; FYD Link raises it to what its batches need.</source>
        <translation>Combien de temps attendent les accélérations (plus une période au plus), pour que les paquets irréguliers arrivent à temps ; FYD Link l'élève selon ses lots.</translation>
    </message>
    <message>
        <source>How much a degree of stretch moves the resonance.</source>
        <translation>De combien un degré d'étirement déplace la résonance.</translation>
    </message>
    <message>
        <source>How often the robot was silent for longer than the link allows.</source>
        <translation>Combien de fois le robot s'est tu plus longtemps que la liaison ne le permet.</translation>
    </message>
    <message>
        <source>How slowly the measured stiffness follows the true one (time constant); auto-tune measures it.</source>
        <translation>Avec quelle lenteur la raideur mesurée suit la vraie (constante de temps) ; le réglage automatique la mesure.</translation>
    </message>
    <message>
        <source>How the cloth gets its target: direct takes the robot's stiffness as it comes, spring its force over the indentation, tdpa the same within the energy that the finger put in, model keeps an estimate that stiffens out of contact or at another place.</source>
        <translation>Comment le tissu reçoit sa consigne : direct prend la raideur du robot comme elle vient, spring sa force divisée par l'indentation, tdpa de même dans l'énergie que le doigt a apportée, model garde une estimation qui durcit hors contact ou à un autre endroit.</translation>
    </message>
    <message>
        <source>How the robot's end says where the finger is now; "thesis" follows late and smoothly.</source>
        <translation>Comment le côté du robot dit où est le doigt maintenant ; "thesis" suit tard et en douceur.</translation>
    </message>
    <message>
        <source>How the stretch follows the stiffness target: law and PID, or as the thesis prints it.</source>
        <translation>Comment l'étirement suit la raideur de consigne : loi et PID, ou comme imprimé dans la thèse.</translation>
    </message>
    <message>
        <source>How three axes of vibration become one signal.</source>
        <translation>Comment trois axes de vibration deviennent un signal.</translation>
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
        <translation>codes IR {}, attendus de 0 à {}</translation>
    </message>
    <message>
        <source>IR sensor {}</source>
        <translation>Capteur IR {}</translation>
    </message>
    <message>
        <source>IR sensor {} is stuck at code {} while the others change: check its cable</source>
        <translation>le capteur IR {} est figé au code {} pendant que les autres changent : vérifier son câble</translation>
    </message>
    <message>
        <source>Identical, bit for bit, as far as it goes.</source>
        <translation>Identique, bit pour bit, jusqu'où elle va.</translation>
    </message>
    <message>
        <source>Identical, bit for bit.</source>
        <translation>Identique, bit pour bit.</translation>
    </message>
    <message>
        <source>Identify cloth and sensors and propose gains; nothing is changed (Ctrl+U)</source>
        <translation>Identifier tissu et capteurs et proposer des gains ; rien n'est changé (Ctrl+U)</translation>
    </message>
    <message>
        <source>In force</source>
        <translation>En vigueur</translation>
    </message>
    <message>
        <source>Inappropriate ioctl for device</source>
        <translation>opération qui ne convient pas à l'appareil</translation>
    </message>
    <message>
        <source>Indentation</source>
        <translation>Indentation</translation>
    </message>
    <message>
        <source>Indentation holding</source>
        <translation>Indentation, doigt immobile</translation>
    </message>
    <message>
        <source>Indentation mode</source>
        <translation>Mode d'indentation</translation>
    </message>
    <message>
        <source>Indentation moving</source>
        <translation>Indentation, doigt mobile</translation>
    </message>
    <message>
        <source>Indentation sigma limit</source>
        <translation>Limite sigma indentation</translation>
    </message>
    <message>
        <source>Indentation, mm</source>
        <translation>Indentation, mm</translation>
    </message>
    <message>
        <source>Input delay</source>
        <translation>Retard d'entrée</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>erreur d'entrée/sortie</translation>
    </message>
    <message>
        <source>Integral gain in thesis mode.</source>
        <translation>Gain intégral en mode thesis.</translation>
    </message>
    <message>
        <source>Integral gain, of the relative error.</source>
        <translation>Gain intégral, de l'erreur relative.</translation>
    </message>
    <message>
        <source>Invalid argument</source>
        <translation>argument non valable</translation>
    </message>
    <message>
        <source>Invalid cross-device link</source>
        <translation>lien entre appareils non valable</translation>
    </message>
    <message>
        <source>Ir noise</source>
        <translation>Bruit IR</translation>
    </message>
    <message>
        <source>Ir offset</source>
        <translation>Décalage IR</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>c'est un dossier</translation>
    </message>
    <message>
        <source>It cannot be proven bit for bit, a part of the recording is lost: %1</source>
        <translation>Cela ne peut être prouvé bit pour bit, une partie de l'enregistrement est perdue : %1</translation>
    </message>
    <message>
        <source>It ends at the first of %1 lost samples.</source>
        <translation>Se termine au premier de %1 échantillons perdus.</translation>
    </message>
    <message>
        <source>It is damaged. Recover keeps what can be proven; it can be opened as it is, too.</source>
        <translation>Il est endommagé. Récupérer garde ce qui peut être prouvé ; il s'ouvre aussi tel quel.</translation>
    </message>
    <message>
        <source>Its recorder crashed, or it is damaged; what can be proven is shown. This makes the recording whole. Nothing is deleted.</source>
        <translation>Son enregistreur s'est interrompu, ou il est endommagé ; ce qui peut être prouvé est montré. Ceci rend l'enregistrement entier. Rien n'est effacé.</translation>
    </message>
    <message>
        <source>Its recorder crashed. Recover makes it whole; it can be opened as it is, too.</source>
        <translation>Son enregistreur s'est interrompu. Récupérer le rend entier ; il s'ouvre aussi tel quel.</translation>
    </message>
    <message>
        <source>Its value</source>
        <translation>Sa valeur</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Gigue</translation>
    </message>
    <message>
        <source>KRC control strategy {}: expected Cartesian impedance</source>
        <translation>stratégie de commande KRC {} : attendu l'impédance cartésienne</translation>
    </message>
    <message>
        <source>KRC in monitor mode: the arm holds; link quality {}; the program on the controller starts command mode</source>
        <translation>KRC en mode moniteur : le bras tient sa place ; qualité de la liaison {} ; le programme sur le contrôleur lance le mode commande</translation>
    </message>
    <message>
        <source>KRC link quality {}: {:.0f} % of its measurements answered; expected good or perfect</source>
        <translation>qualité de la liaison KRC {} : {:.0f} % de ses mesures ont eu une réponse ; attendu bonne ou parfaite</translation>
    </message>
    <message>
        <source>KRC off: open FRI in the program on the controller</source>
        <translation>KRC arrêté : ouvrir FRI dans le programme sur le contrôleur</translation>
    </message>
    <message>
        <source>KRC reports drive errors {:#04x}: acknowledge them on the controller</source>
        <translation>le KRC signale des défauts d'entraînement {:#04x} : les acquitter sur le contrôleur</translation>
    </message>
    <message>
        <source>KRC silent for {:.0f} ms; expected a measurement every 1 to 100 ms: cable, or FRI closed</source>
        <translation>KRC muet depuis {:.0f} ms ; attendu une mesure toutes les 1 à 100 ms : câble, ou FRI fermé</translation>
    </message>
    <message>
        <source>KRC: command mode has just begun, the arm holds</source>
        <translation>KRC : le mode commande vient de commencer, le bras tient sa place</translation>
    </message>
    <message>
        <source>KRC: commanded and measured frame are {:g} m apart; expected at most {:g} m</source>
        <translation>KRC : les repères commandé et mesuré sont à {:g} m l'un de l'autre ; attendu au plus {:g} m</translation>
    </message>
    <message>
        <source>KRC: leap {} mm/s; expected more than 0</source>
        <translation>KRC : saut de {} mm/s ; attendu plus de 0</translation>
    </message>
    <message>
        <source>KRC: none of the last {} answers shows in its commanded frame; expected the place that was commanded</source>
        <translation>KRC : aucune des {} dernières réponses n'apparaît dans son repère commandé ; attendu la place qui avait été commandée</translation>
    </message>
    <message>
        <source>KRC: nothing heard on {}; expected a measurement every 1 to 100 ms: is FRI open on the controller?</source>
        <translation>KRC : rien reçu sur {} ; attendu une mesure toutes les 1 à 100 ms : FRI est-il ouvert sur le contrôleur ?</translation>
    </message>
    <message>
        <source>KRC: period {} ms; expected 1 to 100</source>
        <translation>KRC : période {} ms ; attendu de 1 à 100</translation>
    </message>
    <message>
        <source>KRC: target ({}, {}, {}) mm: expected three finite numbers</source>
        <translation>KRC : cible ({}, {}, {}) mm : attendu trois nombres finis</translation>
    </message>
    <message>
        <source>KRC: the arm is coming to rest</source>
        <translation>KRC : le bras est en train de s'arrêter</translation>
    </message>
    <message>
        <source>KRC: the measured frame moved {:g} m in {} cycles; expected at most {:g} m</source>
        <translation>KRC : le repère mesuré a bougé de {:g} m en {} cycles ; attendu au plus {:g} m</translation>
    </message>
    <message>
        <source>KRC: the remote's address {} has no port to send to</source>
        <translation>KRC : l'adresse {} du côté distant n'a pas de port où envoyer</translation>
    </message>
    <message>
        <source>KRC: the rotation of the {} frame is off by {:g}; expected rows of length 1 at right angles, within {}</source>
        <translation>KRC : la rotation du repère {} est fausse de {:g} ; attendu des lignes de longueur 1 à angle droit, à {} près</translation>
    </message>
    <message>
        <source>KRC: the {} frame is a mirror; expected a rotation (determinant 1)</source>
        <translation>KRC : le repère {} est un miroir ; attendu une rotation (déterminant 1)</translation>
    </message>
    <message>
        <source>KRC: the {} frame is at ({:g}, {:g}, {:g}) m; expected within {:g} m of the base</source>
        <translation>KRC : le repère {} est à ({:g}, {:g}, {:g}) m ; attendu à moins de {:g} m de la base</translation>
    </message>
    <message>
        <source>KRC: {} cannot reach {}: both must be IPv4 or both IPv6</source>
        <translation>KRC : {} ne peut pas atteindre {} : les deux doivent être IPv4 ou tous deux IPv6</translation>
    </message>
    <message>
        <source>KRC: {} {} is {:g} {}; expected within ±{:g} {}</source>
        <translation>KRC : {} {} vaut {:g} {} ; attendu à ±{:g} {} près</translation>
    </message>
    <message>
        <source>KRL real</source>
        <translation>réel KRL</translation>
    </message>
    <message>
        <source>KUKA LWR over FRI on {}</source>
        <translation>KUKA LWR par FRI sur {}</translation>
    </message>
    <message>
        <source>Kalman filter: how much it wanders while the finger presses or lifts.</source>
        <translation>Filtre de Kalman : combien elle varie pendant que le doigt appuie ou se lève.</translation>
    </message>
    <message>
        <source>Kalman filter: how much the indentation wanders while the finger holds still.</source>
        <translation>Filtre de Kalman : combien l'indentation varie pendant que le doigt reste immobile.</translation>
    </message>
    <message>
        <source>Kd</source>
        <translation>Kd</translation>
    </message>
    <message>
        <source>Keep the present values of all live parameters under this name (Enter)</source>
        <translation>Garder sous ce nom les valeurs actuelles de tous les paramètres en direct (Entrée)</translation>
    </message>
    <message>
        <source>Keep the value that is in use (Enter)</source>
        <translation>Garde la valeur en usage (Entrée)</translation>
    </message>
    <message>
        <source>Kept beside the recording, which stays as it is; the list of sessions finds them.</source>
        <translation>Gardées à côté de l'enregistrement, qui reste tel quel ; la liste des sessions les trouve.</translation>
    </message>
    <message>
        <source>Key file</source>
        <translation>Fichier de clé</translation>
    </message>
    <message>
        <source>Key file of FYD Link</source>
        <translation>Fichier de clé de FYD Link</translation>
    </message>
    <message>
        <source>Ki</source>
        <translation>Ki</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Kp</source>
        <translation>Kp</translation>
    </message>
    <message>
        <source>Language: English</source>
        <translation>Langue : anglais</translation>
    </message>
    <message>
        <source>Language: French</source>
        <translation>Langue : français</translation>
    </message>
    <message>
        <source>Language: Italian</source>
        <translation>Langue : italien</translation>
    </message>
    <message>
        <source>Largest duty that vibration may use.</source>
        <translation>Rapport cyclique maximal que la vibration peut utiliser.</translation>
    </message>
    <message>
        <source>Largest relative correction of the law; a measurement that asks for more contradicts it.</source>
        <translation>Plus grande correction relative de la loi ; une mesure qui demande davantage la contredit.</translation>
    </message>
    <message>
        <source>Last answer</source>
        <translation>Dernière réponse</translation>
    </message>
    <message>
        <source>Last message</source>
        <translation>Dernier message</translation>
    </message>
    <message>
        <source>Last picture</source>
        <translation>Dernière image</translation>
    </message>
    <message>
        <source>Last touch: %1 given back beyond what was put in, %2 withheld</source>
        <translation>Dernier contact : %1 rendus au-delà de ce qui fut apporté, %2 retenus</translation>
    </message>
    <message>
        <source>Lasting measurement error</source>
        <translation>Erreur de mesure durable</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Plus tard</translation>
    </message>
    <message>
        <source>Lay the printed target on the cloth, click one of its marks in the picture, type where it lies, and take the point.</source>
        <translation>Poser la cible imprimée sur le tissu, cliquer une de ses marques dans l'image, saisir sa position et prendre le point.</translation>
    </message>
    <message>
        <source>Lay the robot's accelerometer on the cloth, along its motion, and a finger beside it. Then hold the button until the sweep of %1 s is over: at two stretches or more.</source>
        <translation>Posez l'accéléromètre du robot sur le tissu, le long de son mouvement, et un doigt à côté. Puis tenez le bouton jusqu'à la fin du balayage de %1 s : à deux étirements ou plus.</translation>
    </message>
    <message>
        <source>Layouts</source>
        <translation>Dispositions</translation>
    </message>
    <message>
        <source>Layouts…</source>
        <translation>Dispositions…</translation>
    </message>
    <message>
        <source>Least stretch the controller commands.</source>
        <translation>Plus petit étirement que le régulateur commande.</translation>
    </message>
    <message>
        <source>Leave as it is</source>
        <translation>Laisser tel quel</translation>
    </message>
    <message>
        <source>Leave the cell unloaded, type 0 and take the point.</source>
        <translation>Laisser la cellule sans charge, saisir 0 et prendre le point.</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Left as it is</source>
        <translation>Laissé tel quel</translation>
    </message>
    <message>
        <source>Left edge of the cloth in the camera's picture.</source>
        <translation>Bord gauche du tissu dans l'image de la caméra.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Length
s</source>
        <translation>Durée
s</translation>
    </message>
    <message>
        <source>Length, g</source>
        <translation>Norme, g</translation>
    </message>
    <message>
        <source>Let go, type the next stretch, hold the button and press to three depths again.</source>
        <translation>Relâcher, saisir l'étirement suivant, tenir le bouton et presser de nouveau à trois profondeurs.</translation>
    </message>
    <message>
        <source>Letting go or Esc switches them off.</source>
        <translation>Le lâcher ou Esc les coupe.</translation>
    </message>
    <message>
        <source>Light theme</source>
        <translation>Thème clair</translation>
    </message>
    <message>
        <source>Line: grey values of the region. Dashed: the suggested threshold between finger and cloth.</source>
        <translation>Ligne : niveaux de gris de la région. Tirets : le seuil proposé entre doigt et tissu.</translation>
    </message>
    <message>
        <source>Line: new curve. Dashed: the one in force. Crosses: points the others contradict.</source>
        <translation>Ligne : nouvelle courbe. Tirets : celle en vigueur. Croix : points que les autres contredisent.</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Liaison</translation>
    </message>
    <message>
        <source>List of sessions</source>
        <translation>Liste des sessions</translation>
    </message>
    <message>
        <source>Listen on</source>
        <translation>Écouter sur</translation>
    </message>
    <message>
        <source>Listening on</source>
        <translation>À l'écoute sur</translation>
    </message>
    <message>
        <source>Lists serial ports and cameras as "fyd devices" does. Nothing that is in use is disturbed.</source>
        <translation>Liste les ports série et les caméras comme « fyd devices ». Rien de ce qui est utilisé n'est dérangé.</translation>
    </message>
    <message>
        <source>Live parameters, held by the step</source>
        <translation>Paramètres en direct, tenus par le pas</translation>
    </message>
    <message>
        <source>Live reading over the last 30 s, with the points taken</source>
        <translation>Lecture en direct des 30 dernières s, avec les points pris</translation>
    </message>
    <message>
        <source>Live values</source>
        <translation>Valeurs en direct</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Charger</translation>
    </message>
    <message>
        <source>Load cell</source>
        <translation>Cellule de charge</translation>
    </message>
    <message>
        <source>Load cell measures</source>
        <translation>La cellule de charge mesure</translation>
    </message>
    <message>
        <source>Load cell: force that is read with nothing on the cloth; the tare sets it.</source>
        <translation>Cellule de charge : force lue sans rien sur le tissu ; fixée par la tare.</translation>
    </message>
    <message>
        <source>Load cell: grams at 0 mV/V.</source>
        <translation>Cellule de charge : grammes à 0 mV/V.</translation>
    </message>
    <message>
        <source>Load cell: grams per mV/V.</source>
        <translation>Cellule de charge : grammes par mV/V.</translation>
    </message>
    <message>
        <source>Load cell: how far its zero may be off.</source>
        <translation>Cellule de charge : de combien son zéro peut être faux.</translation>
    </message>
    <message>
        <source>Load cell: noise of one reading.</source>
        <translation>Cellule de charge : bruit d'une lecture.</translation>
    </message>
    <message>
        <source>Load cell: readings beyond it are invalid; those at the converter's end always are.</source>
        <translation>Cellule de charge : les lectures au-delà ne sont pas valables ; celles en bout de convertisseur ne le sont jamais.</translation>
    </message>
    <message>
        <source>Load the chosen preset</source>
        <translation>Charger le préréglage choisi</translation>
    </message>
    <message>
        <source>Loading one changes all its values at once; undo takes it back.</source>
        <translation>En charger un change toutes ses valeurs à la fois ; Annuler le retire.</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Chercher à nouveau</translation>
    </message>
    <message>
        <source>Look at its signal</source>
        <translation>Voir son signal</translation>
    </message>
    <message>
        <source>Look at the devices</source>
        <translation>Voir les appareils</translation>
    </message>
    <message>
        <source>Look at the figures at the right, then accept them or measure again.</source>
        <translation>Regarder les valeurs à droite, puis les accepter ou mesurer à nouveau.</translation>
    </message>
    <message>
        <source>Look at the offsets at the right, then accept them or measure again.</source>
        <translation>Regarder les décalages à droite, puis les accepter ou mesurer à nouveau.</translation>
    </message>
    <message>
        <source>Look at the verdict at the right, then accept it, or add a sweep at another stretch.</source>
        <translation>Regardez le verdict à droite, puis acceptez-le, ou ajoutez un balayage à un autre étirement.</translation>
    </message>
    <message>
        <source>Look at the verdict at the right, then accept it, or add presses.</source>
        <translation>Regarder le verdict à droite, puis l'accepter, ou ajouter des appuis.</translation>
    </message>
    <message>
        <source>Look for dirt or an object under the cloth; calibrate.</source>
        <translation>Chercher de la saleté ou un objet sous le tissu ; étalonner.</translation>
    </message>
    <message>
        <source>Looked for: %1
%2

It is tried again by itself. Another camera is chosen in Devices.</source>
        <translation>Cherchée : %1
%2

Un nouvel essai se fait de lui-même. Une autre caméra se choisit dans Appareils.</translation>
    </message>
    <message>
        <source>Looking at cameras …</source>
        <translation>Recherche des caméras …</translation>
    </message>
    <message>
        <source>Looking at serial ports …</source>
        <translation>Recherche des ports série …</translation>
    </message>
    <message>
        <source>Looking for its touches …</source>
        <translation>Recherche de ses touchers …</translation>
    </message>
    <message>
        <source>Looking for touches in %1</source>
        <translation>Recherche des touchers dans %1</translation>
    </message>
    <message>
        <source>Looking for touches …</source>
        <translation>Recherche des touchers …</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Boucle</translation>
    </message>
    <message>
        <source>Loss</source>
        <translation>Perte</translation>
    </message>
    <message>
        <source>Lost: the robot is silent</source>
        <translation>Perdue : le robot se tait</translation>
    </message>
    <message>
        <source>Lower end of %1</source>
        <translation>Borne inférieure de %1</translation>
    </message>
    <message>
        <source>MATLAB</source>
        <translation>MATLAB</translation>
    </message>
    <message>
        <source>MCAP, for robotics viewers</source>
        <translation>MCAP, pour visionneuses de robotique</translation>
    </message>
    <message>
        <source>MJPEG {}: cannot listen: {}</source>
        <translation>MJPEG {} : écoute impossible : {}</translation>
    </message>
    <message>
        <source>Make a gesture card of the chosen touch</source>
        <translation>Faire du toucher choisi une carte de geste</translation>
    </message>
    <message>
        <source>Make a gesture card of this touch</source>
        <translation>Faire de ce toucher une carte de geste</translation>
    </message>
    <message>
        <source>Makes a recording whole whose recorder crashed or that is damaged. Nothing is deleted.</source>
        <translation>Rend entier un enregistrement dont l'enregistreur s'est interrompu ou qui est endommagé. Rien n'est effacé.</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manuel</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>Conversion</translation>
    </message>
    <message>
        <source>Mapping felt: a steady signal of less RMS than this is noise and stays silent.</source>
        <translation>Conversion felt : un signal continu de valeur efficace inférieure est du bruit et reste muet.</translation>
    </message>
    <message>
        <source>Mapping felt: largest RMS duty over a second, for the motors' heat.</source>
        <translation>Conversion felt : rapport cyclique RMS maximal sur une seconde, pour la chaleur des moteurs.</translation>
    </message>
    <message>
        <source>Mapping felt: stored RMS of the surface, to which the gain is fitted; 0 learns it from the touch.</source>
        <translation>Conversion felt : valeur efficace enregistrée de la surface, à laquelle le gain est ajusté ; 0 l'apprend du toucher.</translation>
    </message>
    <message>
        <source>Mapping from signal to duty: so that the finger feels it, rounded alike on both sides, or as the thesis prints it.</source>
        <translation>Conversion du signal en rapport cyclique : pour que le doigt la sente, arrondie pareillement des deux côtés, ou telle que la thèse l'imprime.</translation>
    </message>
    <message>
        <source>Mappings symmetric and thesis: duties smaller than this become zero, as the motors would not turn.</source>
        <translation>Conversions symmetric et thesis : les rapports cycliques plus petits que celui-ci deviennent zéro, car les moteurs ne tourneraient pas.</translation>
    </message>
    <message>
        <source>Marked values differ from the profile (Ctrl+S)</source>
        <translation>Les valeurs marquées diffèrent du profil (Ctrl+S)</translation>
    </message>
    <message>
        <source>Marker %1</source>
        <translation>Marqueur %1</translation>
    </message>
    <message>
        <source>Marker %1 at %2.</source>
        <translation>Marqueur %1 à %2.</translation>
    </message>
    <message>
        <source>Marker into the recording</source>
        <translation>Marqueur dans l'enregistrement</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Masque</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Maximum gap</source>
        <translation>Lacune maximale</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Mean of the others, mm</source>
        <translation>Moyenne des autres, mm</translation>
    </message>
    <message>
        <source>Measured, °</source>
        <translation>Mesuré, °</translation>
    </message>
    <message>
        <source>Measured.</source>
        <translation>Mesuré.</translation>
    </message>
    <message>
        <source>Measurement delay</source>
        <translation>Temps mort de la mesure</translation>
    </message>
    <message>
        <source>Measurement lag</source>
        <translation>Retard de la mesure</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Millimetres per pixel along a picture column.</source>
        <translation>Millimètres par pixel le long d'une colonne de l'image.</translation>
    </message>
    <message>
        <source>Millimetres per pixel along a picture row.</source>
        <translation>Millimètres par pixel le long d'une ligne de l'image.</translation>
    </message>
    <message>
        <source>Mine …</source>
        <translation>Le mien …</translation>
    </message>
    <message>
        <source>Missing now: %1</source>
        <translation>Manque à présent : %1</translation>
    </message>
    <message>
        <source>Modbus TCP {}: cannot listen: {}</source>
        <translation>Modbus TCP {} : écoute impossible : {}</translation>
    </message>
    <message>
        <source>Motion depth scale</source>
        <translation>Échelle en profondeur</translation>
    </message>
    <message>
        <source>Motion scale</source>
        <translation>Échelle du mouvement</translation>
    </message>
    <message>
        <source>Motion speed limit</source>
        <translation>Vitesse maximale</translation>
    </message>
    <message>
        <source>Motor 1, °</source>
        <translation>Moteur 1, °</translation>
    </message>
    <message>
        <source>Motor 2, °</source>
        <translation>Moteur 2, °</translation>
    </message>
    <message>
        <source>Motor board</source>
        <translation>Carte moteurs</translation>
    </message>
    <message>
        <source>Motor board (qbmove)</source>
        <translation>Carte moteurs (qbmove)</translation>
    </message>
    <message>
        <source>Motors</source>
        <translation>Moteurs</translation>
    </message>
    <message>
        <source>Motors and cloth answer (closed loop)</source>
        <translation>Moteurs et tissu répondent (boucle fermée)</translation>
    </message>
    <message>
        <source>Motors answer</source>
        <translation>Les moteurs répondent</translation>
    </message>
    <message>
        <source>Motors off at once (Esc, from everywhere)</source>
        <translation>Moteurs coupés aussitôt (Esc, de partout)</translation>
    </message>
    <message>
        <source>Motors' vibration</source>
        <translation>Vibration des moteurs</translation>
    </message>
    <message>
        <source>Move the target by some 20 mm, type the new distance and take the next point, 40 to 300 mm.</source>
        <translation>Déplacer la cible d'environ 20 mm, saisir la nouvelle distance et prendre le point suivant, de 40 à 300 mm.</translation>
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
        <translation>NaN n'est pas un temps</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Name of the present layout</source>
        <translation>Nom de la disposition présente</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Nom du préréglage</translation>
    </message>
    <message>
        <source>Network (Modbus TCP)</source>
        <translation>Réseau (Modbus TCP)</translation>
    </message>
    <message>
        <source>Network is down</source>
        <translation>le réseau est arrêté</translation>
    </message>
    <message>
        <source>Network is unreachable</source>
        <translation>réseau injoignable</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nouveau</translation>
    </message>
    <message>
        <source>Next picture</source>
        <translation>Image suivante</translation>
    </message>
    <message>
        <source>Next sample</source>
        <translation>Échantillon suivant</translation>
    </message>
    <message>
        <source>Next trial</source>
        <translation>Essai suivant</translation>
    </message>
    <message>
        <source>No layout is saved yet. Move the panels and choose the curves as you like them, then write a name.</source>
        <translation>Aucune disposition n'est encore enregistrée. Placer les panneaux et choisir les courbes à son gré, puis saisir un nom.</translation>
    </message>
    <message>
        <source>No link</source>
        <translation>Pas de liaison</translation>
    </message>
    <message>
        <source>No marker: nothing is being recorded. Ctrl+R starts.</source>
        <translation>Pas de marqueur : rien n'est enregistré. Ctrl+R commence.</translation>
    </message>
    <message>
        <source>No motor is sent further than this from its zero, whatever stretch and translation add up to.</source>
        <translation>Aucun moteur n'est envoyé plus loin que cela de son zéro, quelle que soit la somme de l'étirement et de la translation.</translation>
    </message>
    <message>
        <source>No notes. N writes one at the cursor.</source>
        <translation>Pas de notes. N en écrit une au curseur.</translation>
    </message>
    <message>
        <source>No notices. Everything that was said is in the log (Ctrl+L).</source>
        <translation>Aucun avis. Tout ce qui a été dit est dans le journal (Ctrl+L).</translation>
    </message>
    <message>
        <source>No parameter is found so. The search looks at name, identifier, help and group.</source>
        <translation>Aucun paramètre trouvé ainsi. La recherche porte sur nom, identifiant, aide et groupe.</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Pas d'image</translation>
    </message>
    <message>
        <source>No picture at the cursor.</source>
        <translation>Pas d'image au curseur.</translation>
    </message>
    <message>
        <source>No picture was taken before the cursor.</source>
        <translation>Aucune image n'a été prise avant le curseur.</translation>
    </message>
    <message>
        <source>No picture yet.</source>
        <translation>Pas encore d'image.</translation>
    </message>
    <message>
        <source>No pictures were recorded.</source>
        <translation>Aucune image n'a été enregistrée.</translation>
    </message>
    <message>
        <source>No points yet. The values in force stay until you accept new ones.</source>
        <translation>Pas encore de points. Les valeurs en vigueur restent jusqu'à l'acceptation de nouvelles.</translation>
    </message>
    <message>
        <source>No preset yet. Tune what you like to keep, write a name and press Save.</source>
        <translation>Pas encore de préréglage. Régler ce qui est à garder, saisir un nom et presser Enregistrer.</translation>
    </message>
    <message>
        <source>No preset yet; the place Tune saves one</source>
        <translation>Pas encore de préréglage ; le lieu Réglage en enregistre</translation>
    </message>
    <message>
        <source>No real-time priority: the system may delay the loop.</source>
        <translation>Pas de priorité temps réel : le système peut retarder la boucle.</translation>
    </message>
    <message>
        <source>No recording was opened yet</source>
        <translation>Aucun enregistrement n'a encore été ouvert</translation>
    </message>
    <message>
        <source>No report: %1.</source>
        <translation>Pas de rapport : %1.</translation>
    </message>
    <message>
        <source>No robot on a network: the target is a scene's, or set by hand.</source>
        <translation>Aucun robot sur un réseau : la consigne est celle d’une scène, ou réglée à la main.</translation>
    </message>
    <message>
        <source>No route to host</source>
        <translation>pas de route vers l'hôte</translation>
    </message>
    <message>
        <source>No scene stands where the robot stands. Choose a scene file as the robot, in the link's panel, or start with --robot scene:FILE.</source>
        <translation>Aucune scène à la place du robot. Choisir un fichier de scène comme robot, dans le panneau de la liaison, ou démarrer avec --robot scene:FILE.</translation>
    </message>
    <message>
        <source>No scene yet.</source>
        <translation>Pas encore de scène.</translation>
    </message>
    <message>
        <source>No sensor of the touchpad answers.</source>
        <translation>Aucun capteur du touchpad ne répond.</translation>
    </message>
    <message>
        <source>No serial port and no camera. A touchpad on the network is not searched for: enter its address. Simulated parts work without any.</source>
        <translation>Aucun port série et aucune caméra. Un touchpad sur le réseau n’est pas cherché : entrer son adresse. Les parties simulées marchent sans.</translation>
    </message>
    <message>
        <source>No session has these words.</source>
        <translation>Aucune session n'a ces mots.</translation>
    </message>
    <message>
        <source>No session is in the catalogue yet. Record one in Operate (Ctrl+R), or name a recording's file below.</source>
        <translation>Aucune session n'est encore au catalogue. En enregistrer une dans Conduite (Ctrl+R), ou indiquer ci-dessous le fichier d'un enregistrement.</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>plus de place sur le disque</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>appareil absent</translation>
    </message>
    <message>
        <source>No such device or address</source>
        <translation>appareil ou adresse inexistants</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>aucun fichier ou dossier de ce nom</translation>
    </message>
    <message>
        <source>No trial was begun: nothing is being recorded. Ctrl+R starts.</source>
        <translation>Aucun essai commencé : rien n'est enregistré. Ctrl+R commence.</translation>
    </message>
    <message>
        <source>No trials are planned: start with --trials soft,hard,…</source>
        <translation>Aucun essai prévu : démarrer avec --trials soft,hard,…</translation>
    </message>
    <message>
        <source>No-touch offsets</source>
        <translation>Décalages sans contact</translation>
    </message>
    <message>
        <source>Noise correlation</source>
        <translation>Corrélation du bruit</translation>
    </message>
    <message>
        <source>Noise gate</source>
        <translation>Seuil de bruit</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>None: a mean, or points without scatter.</source>
        <translation>Aucune : une moyenne, ou des points sans dispersion.</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>ce n'est pas un dossier</translation>
    </message>
    <message>
        <source>Not accepted, the old values stay. %1</source>
        <translation>Non accepté, les anciennes valeurs restent. %1</translation>
    </message>
    <message>
        <source>Not applied yet</source>
        <translation>Pas encore appliqué</translation>
    </message>
    <message>
        <source>Not applied yet.</source>
        <translation>Pas encore appliqué.</translation>
    </message>
    <message>
        <source>Not armed: {}. {}</source>
        <translation>Non armé : {}. {}</translation>
    </message>
    <message>
        <source>Not connected. %1</source>
        <translation>Non connecté. %1</translation>
    </message>
    <message>
        <source>Not connected; all is as it was. %1.</source>
        <translation>Non connecté ; tout est comme avant. %1.</translation>
    </message>
    <message>
        <source>Not connected; the former devices are back. %1.</source>
        <translation>Non connecté ; les appareils précédents sont de retour. %1.</translation>
    </message>
    <message>
        <source>Not following: press F</source>
        <translation>Suivi arrêté : touche F</translation>
    </message>
    <message>
        <source>Not moved: %1.</source>
        <translation>Pas de mouvement : %1.</translation>
    </message>
    <message>
        <source>Not moved: see the entry at the left.</source>
        <translation>Pas de mouvement : voir le champ à gauche.</translation>
    </message>
    <message>
        <source>Not recording. %1.</source>
        <translation>Pas d'enregistrement. %1.</translation>
    </message>
    <message>
        <source>Not recording. Folder %1 cannot be made: choose another file.</source>
        <translation>Pas d'enregistrement. Le dossier %1 ne peut être créé : choisir un autre fichier.</translation>
    </message>
    <message>
        <source>Not secured</source>
        <translation>Non sécurisée</translation>
    </message>
    <message>
        <source>Not taken: %1.</source>
        <translation>Non pris : %1.</translation>
    </message>
    <message>
        <source>Not taken: %1. Wait until it rests and take the point again.</source>
        <translation>Non pris : %1. Attendre le repos et reprendre le point.</translation>
    </message>
    <message>
        <source>Not taken: a tare came in between. Take the point again.</source>
        <translation>Non pris : une tare est venue entre-temps. Reprendre le point.</translation>
    </message>
    <message>
        <source>Not taken: see the entry at the left.</source>
        <translation>Non pris : voir la saisie à gauche.</translation>
    </message>
    <message>
        <source>Not yet: %1.</source>
        <translation>Pas encore : %1.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Note at the cursor</source>
        <translation>Note au curseur</translation>
    </message>
    <message>
        <source>Note at the cursor, then Enter</source>
        <translation>Note au curseur, puis Entrée</translation>
    </message>
    <message>
        <source>Note in the recording: %1</source>
        <translation>Note dans l'enregistrement : %1</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Notes and events</source>
        <translation>Notes et événements</translation>
    </message>
    <message>
        <source>Notes: %1 characters are too many; at most %2.</source>
        <translation>Notes : %1 caractères, c'est trop ; au plus %2.</translation>
    </message>
    <message>
        <source>Nothing differs from the profile (Ctrl+S)</source>
        <translation>Rien ne diffère du profil (Ctrl+S)</translation>
    </message>
    <message>
        <source>Nothing differs from the saved profile. Change a value at the left and it is listed here; A and B then switch between saved and current while you feel.</source>
        <translation>Rien ne diffère du profil enregistré. Une valeur changée à gauche apparaît ici ; A et B passent alors de l'enregistré à l'actuel pendant que l'on touche.</translation>
    </message>
    <message>
        <source>Nothing differs from the saved values</source>
        <translation>Rien ne diffère des valeurs enregistrées</translation>
    </message>
    <message>
        <source>Nothing in the manual has these words.</source>
        <translation>Rien dans le manuel n'a ces mots.</translation>
    </message>
    <message>
        <source>Nothing is checked or hidden: whoever reaches this address can pose as the robot. Use it on a line of its own.</source>
        <translation>Rien n'est vérifié ni caché : quiconque atteint cette adresse peut se faire passer pour le robot. L'utiliser sur une ligne réservée.</translation>
    </message>
    <message>
        <source>Nothing is checked or hidden; only programs on this computer reach it.</source>
        <translation>Rien n'est vérifié ni caché ; seuls les programmes de cet ordinateur y accèdent.</translation>
    </message>
    <message>
        <source>Nothing is running here.</source>
        <translation>Rien n'est en cours ici.</translation>
    </message>
    <message>
        <source>Nothing is written. %1. Mend or move that file.</source>
        <translation>Rien n’est écrit. %1. Corriger ou déplacer ce fichier.</translation>
    </message>
    <message>
        <source>Nothing of %1 can be read; it is left as it is: %2</source>
        <translation>Rien de %1 n'est lisible ; il reste tel quel : %2</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>Rien à rétablir</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>Rien à annuler</translation>
    </message>
    <message>
        <source>Notice</source>
        <translation>Avis</translation>
    </message>
    <message>
        <source>Notices</source>
        <translation>Avis</translation>
    </message>
    <message>
        <source>Of a difference from the law: excess corrects what exceeds the lasting error, bounded twice that, at most all of it: never worse than the law alone either way.</source>
        <translation>D'un écart à la loi : excess corrige ce qui dépasse l'erreur qui peut durer, bounded le double, au plus le tout : dans les deux cas jamais pire que la loi seule.</translation>
    </message>
    <message>
        <source>Off: each curve is moved and zoomed by itself (T)</source>
        <translation>Désactivé : chaque courbe se déplace et se zoome seule (T)</translation>
    </message>
    <message>
        <source>Offset, mm</source>
        <translation>Décalage, mm</translation>
    </message>
    <message>
        <source>Oldest distance reading the step still trusts.</source>
        <translation>Âge maximal d'une lecture de distance à laquelle le pas se fie encore.</translation>
    </message>
    <message>
        <source>Oldest encoder reading the step still trusts.</source>
        <translation>Âge maximal d'une lecture des codeurs à laquelle le pas se fie encore.</translation>
    </message>
    <message>
        <source>Oldest load-cell reading the step still trusts.</source>
        <translation>Âge maximal d'une lecture de la cellule de charge à laquelle le pas se fie encore.</translation>
    </message>
    <message>
        <source>Oldest picture the step still trusts.</source>
        <translation>Âge maximal d'une image à laquelle le pas se fie encore.</translation>
    </message>
    <message>
        <source>On a cloth 30 % softer than its law says, with the sensors that the profile describes. Auto-tune finds out more.</source>
        <translation>Sur un tissu 30 % plus souple que ne le dit sa loi, avec les capteurs décrits par le profil. Le réglage automatique en apprend plus.</translation>
    </message>
    <message>
        <source>On the cloth that auto-tune identified, 30 % softer than its law says.</source>
        <translation>Sur le tissu identifié par le réglage automatique, 30 % plus souple que ne le dit sa loi.</translation>
    </message>
    <message>
        <source>One measurement of %1 s.</source>
        <translation>Une mesure de %1 s.</translation>
    </message>
    <message>
        <source>One measurement of 3 s.</source>
        <translation>Une mesure de 3 s.</translation>
    </message>
    <message>
        <source>One sweep of at least %1° with 5 angles.</source>
        <translation>Un balayage d'au moins %1° avec 5 angles.</translation>
    </message>
    <message>
        <source>One time for all curves</source>
        <translation>Un seul temps pour toutes les courbes</translation>
    </message>
    <message>
        <source>Only a robot with the same key is heard; what is said cannot be read or changed.</source>
        <translation>Seul un robot avec la même clé est entendu ; ce qui est dit ne peut être ni lu ni changé.</translation>
    </message>
    <message>
        <source>Only what differs</source>
        <translation>Différences seules</translation>
    </message>
    <message>
        <source>Only while nothing renders: press Esc first.</source>
        <translation>Seulement sans rendu : appuyer d'abord sur Esc.</translation>
    </message>
    <message>
        <source>Only with motors that answer.</source>
        <translation>Seulement avec des moteurs qui répondent.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Ouvrir un fichier…</translation>
    </message>
    <message>
        <source>Open a recording…</source>
        <translation>Ouvrir un enregistrement…</translation>
    </message>
    <message>
        <source>Open loop: the recorded inputs as they were; the cloth does not answer.</source>
        <translation>Boucle ouverte : les entrées enregistrées telles quelles ; le tissu ne répond pas.</translation>
    </message>
    <message>
        <source>Opened lately</source>
        <translation>Ouverts récemment</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>Conduite</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>opération non permise</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Opérateur</translation>
    </message>
    <message>
        <source>Operator: expected one line of at most %1 characters.</source>
        <translation>Opérateur : attendu une ligne d'au plus %1 caractères.</translation>
    </message>
    <message>
        <source>Operator: who operates? A name or initials.</source>
        <translation>Opérateur : qui conduit ? Un nom ou des initiales.</translation>
    </message>
    <message>
        <source>Other devices are being connected …</source>
        <translation>D'autres appareils sont en cours de connexion …</translation>
    </message>
    <message>
        <source>Other devices are connected: calibration points of the former ones are discarded (%1).</source>
        <translation>D'autres appareils sont connectés : les points d'étalonnage des précédents sont écartés (%1).</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Dépassement</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>Page du manuel</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Panneaux</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Paramètre</translation>
    </message>
    <message>
        <source>Parameter %1</source>
        <translation>Paramètre %1</translation>
    </message>
    <message>
        <source>Parameter to change</source>
        <translation>Paramètre à changer</translation>
    </message>
    <message>
        <source>Parts and link</source>
        <translation>Parties et liaison</translation>
    </message>
    <message>
        <source>Parts and the age of their calibration</source>
        <translation>Parties et âge de leur étalonnage</translation>
    </message>
    <message>
        <source>Path of a recording</source>
        <translation>Chemin d'un enregistrement</translation>
    </message>
    <message>
        <source>Path of a recording, such as %1</source>
        <translation>Chemin d'un enregistrement, comme %1</translation>
    </message>
    <message>
        <source>Path of a second recording</source>
        <translation>Chemin d'un second enregistrement</translation>
    </message>
    <message>
        <source>Path of a second recording, then Enter</source>
        <translation>Chemin d'un second enregistrement, puis Entrée</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Pause or follow</source>
        <translation>Pause ou suivi</translation>
    </message>
    <message>
        <source>Paused by the robot</source>
        <translation>Mise en pause par le robot</translation>
    </message>
    <message>
        <source>Period of the thesis' control law.</source>
        <translation>Période de la loi de commande de la thèse.</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>permission refusée</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>Marge de phase</translation>
    </message>
    <message>
        <source>Picture column of the touchpad's origin.</source>
        <translation>Colonne de l'image de l'origine du touchpad.</translation>
    </message>
    <message>
        <source>Picture row of the touchpad's origin.</source>
        <translation>Ligne de l'image de l'origine du touchpad.</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Pixels</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Lieux</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lire</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Lecture ou pause</translation>
    </message>
    <message>
        <source>Play or pause (Space)</source>
        <translation>Lecture ou pause (Espace)</translation>
    </message>
    <message>
        <source>Plugged in</source>
        <translation>Branchés</translation>
    </message>
    <message>
        <source>Point %1 taken.</source>
        <translation>Point %1 pris.</translation>
    </message>
    <message>
        <source>Points as the simulated touchpad gives them; the record says that they are simulated.</source>
        <translation>Points tels que les donne le touchpad simulé ; le procès-verbal dit qu'ils sont simulés.</translation>
    </message>
    <message>
        <source>Points discarded; the values in force stay.</source>
        <translation>Points écartés ; les valeurs en vigueur restent.</translation>
    </message>
    <message>
        <source>Points taken</source>
        <translation>Points pris</translation>
    </message>
    <message>
        <source>Points, fit and residuals</source>
        <translation>Points, ajustement et résidus</translation>
    </message>
    <message>
        <source>Position sent</source>
        <translation>Position envoyée</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>Prédit</translation>
    </message>
    <message>
        <source>Predicted ahead</source>
        <translation>Prédit en avance</translation>
    </message>
    <message>
        <source>Prediction error</source>
        <translation>Écart constaté</translation>
    </message>
    <message>
        <source>Predictor</source>
        <translation>Prédicteur</translation>
    </message>
    <message>
        <source>Present</source>
        <translation>Actuel</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Préréglages</translation>
    </message>
    <message>
        <source>Press Esc, then restart the program.</source>
        <translation>Appuyer sur Esc, puis redémarrer le programme.</translation>
    </message>
    <message>
        <source>Press over distance sensor %1 once more, twice as deep and at least %2.</source>
        <translation>Appuyer encore une fois au-dessus du capteur de distance %1, deux fois plus profond et d'au moins %2.</translation>
    </message>
    <message>
        <source>Press over distance sensor %1, some 3 mm deep.</source>
        <translation>Appuyer au-dessus du capteur de distance %1, d'environ 3 mm.</translation>
    </message>
    <message>
        <source>Press the cloth now, and hold the depth for a second.</source>
        <translation>Presser maintenant le tissu et tenir la profondeur une seconde.</translation>
    </message>
    <message>
        <source>Previous picture</source>
        <translation>Image précédente</translation>
    </message>
    <message>
        <source>Previous sample</source>
        <translation>Échantillon précédent</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problème</translation>
    </message>
    <message>
        <source>Profile not saved. %1</source>
        <translation>Profil non enregistré. %1</translation>
    </message>
    <message>
        <source>Profile saved to %1.</source>
        <translation>Profil enregistré dans %1.</translation>
    </message>
    <message>
        <source>Progress of auto-tune</source>
        <translation>Avancement du réglage automatique</translation>
    </message>
    <message>
        <source>Proportional gain in thesis mode.</source>
        <translation>Gain proportionnel en mode thesis.</translation>
    </message>
    <message>
        <source>Proportional gain: relative correction for relative error.</source>
        <translation>Gain proportionnel : correction relative pour erreur relative.</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>Proposé</translation>
    </message>
    <message>
        <source>Proposed values</source>
        <translation>Valeurs proposées</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protocole</translation>
    </message>
    <message>
        <source>Proxy</source>
        <translation>Proxy</translation>
    </message>
    <message>
        <source>Put the cursor somewhere and press [ for A, elsewhere and press ] for B.</source>
        <translation>Placer le curseur quelque part et appuyer sur [ pour A, ailleurs et sur ] pour B.</translation>
    </message>
    <message>
        <source>Put the next known weight on the cell, type it, wait until it rests, take the point.</source>
        <translation>Poser le poids connu suivant sur la cellule, le saisir, attendre le repos, prendre le point.</translation>
    </message>
    <message>
        <source>Put the robot to rest with its tool in the air, and take the point: it lasts 3 s.</source>
        <translation>Mettre le robot au repos, outil en l'air, et prendre le point : cela dure 3 s.</translation>
    </message>
    <message>
        <source>Puts it into the form; nothing is connected yet.</source>
        <translation>Le met dans le formulaire ; rien n’est encore connecté.</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Quit? Now: %1. Quitting stops the motors and closes the recording; what is not finished is lost. Ctrl+Q again quits.</source>
        <translation>Quitter ? En ce moment : %1. Quitter arrête les moteurs et ferme l'enregistrement ; ce qui n'est pas fini est perdu. Encore Ctrl+Q quitte.</translation>
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
        <translation>Rayon du contact du doigt avec le tissu quand aucune aire ne le dit.</translation>
    </message>
    <message>
        <source>Radius of the rollers, cloth included.</source>
        <translation>Rayon des rouleaux, tissu compris.</translation>
    </message>
    <message>
        <source>Rate at which the texture step is called and its filters are designed.</source>
        <translation>Fréquence à laquelle le pas de texture est appelé et pour laquelle ses filtres sont conçus.</translation>
    </message>
    <message>
        <source>Rate limit</source>
        <translation>Limite de vitesse</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Lu</translation>
    </message>
    <message>
        <source>Read back</source>
        <translation>Relu</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>système de fichiers en lecture seule</translation>
    </message>
    <message>
        <source>Readiness</source>
        <translation>Préparation</translation>
    </message>
    <message>
        <source>Readiness list</source>
        <translation>Liste de préparation</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>Reading the scene. The present session goes on until it is read.</source>
        <translation>Lecture de la scène en cours. La session actuelle continue jusqu’à ce qu’elle soit lue.</translation>
    </message>
    <message>
        <source>Reading, counts</source>
        <translation>Lecture, pts</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Prêt</translation>
    </message>
    <message>
        <source>Ready? %1/%2</source>
        <translation>Prêt ? %1/%2</translation>
    </message>
    <message>
        <source>Ready? Waiting for the station</source>
        <translation>Prêt ? En attente de la station</translation>
    </message>
    <message>
        <source>Real-time priority granted.</source>
        <translation>Priorité temps réel accordée.</translation>
    </message>
    <message>
        <source>Received</source>
        <translation>Reçus</translation>
    </message>
    <message>
        <source>Reckoning between A and B</source>
        <translation>Calcul entre A et B</translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation>Reconnecter</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Record this session into a file (Ctrl+R)</source>
        <translation>Enregistrer cette session dans un fichier (Ctrl+R)</translation>
    </message>
    <message>
        <source>Recorded sessions</source>
        <translation>Sessions enregistrées</translation>
    </message>
    <message>
        <source>Recorded with arithmetic %1, replayed with %2: the bits cannot be the same.</source>
        <translation>Enregistré avec l'arithmétique %1, rejoué avec la %2 : les bits ne peuvent pas être les mêmes.</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Recording closed: %1.</source>
        <translation>Enregistrement fermé : %1.</translation>
    </message>
    <message>
        <source>Recording failed
Press to read why</source>
        <translation>Échec de l'enregistrement
Appuyer pour lire pourquoi</translation>
    </message>
    <message>
        <source>Recording failed. %1</source>
        <translation>Échec de l'enregistrement. %1</translation>
    </message>
    <message>
        <source>Recording into %1.</source>
        <translation>Enregistrement dans %1.</translation>
    </message>
    <message>
        <source>Recording to compare with</source>
        <translation>Enregistrement à comparer</translation>
    </message>
    <message>
        <source>Recording to open</source>
        <translation>Enregistrement à ouvrir</translation>
    </message>
    <message>
        <source>Recording, played back</source>
        <translation>Enregistrement, rejoué</translation>
    </message>
    <message>
        <source>Recordings (*.h5 *.h5.partial *.h5.damaged*);;All files (*)</source>
        <translation>Enregistrements (*.h5 *.h5.partial *.h5.damaged*);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Recordings (*.h5)</source>
        <translation>Enregistrements (*.h5)</translation>
    </message>
    <message>
        <source>Recordings (*.h5);;All files (*)</source>
        <translation>Enregistrements (*.h5);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Record…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Récupérer</translation>
    </message>
    <message>
        <source>Recover a crashed recording</source>
        <translation>Récupérer un enregistrement interrompu</translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation>Récupération de %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Redo %1 (Ctrl+Shift+Z)</source>
        <translation>Rétablir %1 (Ctrl+Maj+Z)</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Refusés : %1</translation>
    </message>
    <message>
        <source>Refused: %1.</source>
        <translation>Refusé : %1.</translation>
    </message>
    <message>
        <source>Refused: none</source>
        <translation>Refusés : aucun</translation>
    </message>
    <message>
        <source>Relative error of the measured stiffness that may last; what is corrected beyond it control.correction says.</source>
        <translation>Erreur relative de la raideur mesurée qui peut durer ; ce qui est corrigé au-delà, control.correction le dit.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Rename the chosen preset</source>
        <translation>Renommer le préréglage choisi</translation>
    </message>
    <message>
        <source>Rendering; motors on.</source>
        <translation>Rendu en cours ; moteurs en marche.</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Report as PDF</source>
        <translation>Rapport en PDF</translation>
    </message>
    <message>
        <source>Report as web page</source>
        <translation>Rapport en page web</translation>
    </message>
    <message>
        <source>Report written to %1.</source>
        <translation>Rapport écrit dans %1.</translation>
    </message>
    <message>
        <source>Reset %1 to its default</source>
        <translation>Ramener %1 à sa valeur par défaut</translation>
    </message>
    <message>
        <source>Residual, Hz</source>
        <translation>Résidu, Hz</translation>
    </message>
    <message>
        <source>Residual, N</source>
        <translation>Résidu, N</translation>
    </message>
    <message>
        <source>Residual, mm</source>
        <translation>Résidu, mm</translation>
    </message>
    <message>
        <source>Residual, °</source>
        <translation>Résidu, °</translation>
    </message>
    <message>
        <source>Resonance of the cloth with a finger on it, at the stretch below.</source>
        <translation>Résonance du tissu avec un doigt dessus, à l'étirement ci-dessous.</translation>
    </message>
    <message>
        <source>Resonance, Hz</source>
        <translation>Résonance, Hz</translation>
    </message>
    <message>
        <source>Resource temporarily unavailable</source>
        <translation>ressource temporairement indisponible</translation>
    </message>
    <message>
        <source>Rest a finger on the cloth, drag a rectangle around the cloth in the picture, and take the point.</source>
        <translation>Poser un doigt sur le tissu, tracer un rectangle autour du tissu dans l'image et prendre le point.</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Relecture</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Rise time</source>
        <translation>Temps de montée</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Robot connected</source>
        <translation>Robot connecté</translation>
    </message>
    <message>
        <source>Robot's position</source>
        <translation>Position du robot</translation>
    </message>
    <message>
        <source>Robot's travel downward for the finger's indentation.</source>
        <translation>Course du robot vers le bas pour l'indentation du doigt.</translation>
    </message>
    <message>
        <source>Robot's travel for the finger's along the cloth.</source>
        <translation>Course du robot pour celle du doigt le long du tissu.</translation>
    </message>
    <message>
        <source>Robot: %1 …</source>
        <translation>Robot : %1 …</translation>
    </message>
    <message>
        <source>Robot…</source>
        <translation>Robot…</translation>
    </message>
    <message>
        <source>Round trip</source>
        <translation>Aller-retour</translation>
    </message>
    <message>
        <source>Run again</source>
        <translation>Rejouer</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>En marche</translation>
    </message>
    <message>
        <source>Running %1 again</source>
        <translation>Nouvelle exécution de %1</translation>
    </message>
    <message>
        <source>Running …</source>
        <translation>En cours …</translation>
    </message>
    <message>
        <source>Runs the recorded inputs through the step again. Without a change it proves that the recording comes out the same, bit for bit.</source>
        <translation>Refait passer les entrées enregistrées par le pas. Sans changement, cela prouve que l'enregistrement ressort identique, bit pour bit.</translation>
    </message>
    <message>
        <source>SIMULATED: %1</source>
        <translation>SIMULÉ : %1</translation>
    </message>
    <message>
        <source>Samples in a frame of dft321: more resolution for more delay.</source>
        <translation>Échantillons dans une trame de dft321 : plus de résolution pour plus de retard.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Save a preset…</source>
        <translation>Enregistrer un préréglage…</translation>
    </message>
    <message>
        <source>Save layout</source>
        <translation>Enregistrer la disposition</translation>
    </message>
    <message>
        <source>Save profile</source>
        <translation>Enregistrer le profil</translation>
    </message>
    <message>
        <source>Save the curves as PDF</source>
        <translation>Enregistrer les courbes en PDF</translation>
    </message>
    <message>
        <source>Save the curves as PNG</source>
        <translation>Enregistrer les courbes en PNG</translation>
    </message>
    <message>
        <source>Save the curves as SVG</source>
        <translation>Enregistrer les courbes en SVG</translation>
    </message>
    <message>
        <source>Save the values shown as CSV</source>
        <translation>Enregistrer les valeurs affichées en CSV</translation>
    </message>
    <message>
        <source>Saved layouts</source>
        <translation>Dispositions enregistrées</translation>
    </message>
    <message>
        <source>Saved profile</source>
        <translation>Profil enregistré</translation>
    </message>
    <message>
        <source>Scale of the colours</source>
        <translation>Échelle des couleurs</translation>
    </message>
    <message>
        <source>Scale of the spectrum</source>
        <translation>Échelle du spectre</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>Scene file</source>
        <translation>Fichier de la scène</translation>
    </message>
    <message>
        <source>Scene panel</source>
        <translation>Panneau de la scène</translation>
    </message>
    <message>
        <source>Scenes (*.toml);;All files (*)</source>
        <translation>Scènes (*.toml);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Search for devices</source>
        <translation>Chercher des appareils</translation>
    </message>
    <message>
        <source>Search operator, subject, notes, tags</source>
        <translation>Chercher opérateur, sujet, notes, étiquettes</translation>
    </message>
    <message>
        <source>Search parameters</source>
        <translation>Chercher des paramètres</translation>
    </message>
    <message>
        <source>Search the log</source>
        <translation>Chercher dans le journal</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Chercher dans le manuel</translation>
    </message>
    <message>
        <source>Searching …</source>
        <translation>Recherche …</translation>
    </message>
    <message>
        <source>Second encoder's reading at zero stretch.</source>
        <translation>Lecture du second codeur à étirement nul.</translation>
    </message>
    <message>
        <source>Secured</source>
        <translation>Sécurisée</translation>
    </message>
    <message>
        <source>Selected values back to saved</source>
        <translation>Valeurs choisies : retour aux valeurs enregistrées</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Capteur</translation>
    </message>
    <message>
        <source>Sensors live, motors off.</source>
        <translation>Capteurs actifs, moteurs coupés.</translation>
    </message>
    <message>
        <source>Sensors nearer to one line than this condition number make no plane.</source>
        <translation>Des capteurs plus proches d'une droite que ce conditionnement ne font pas un plan.</translation>
    </message>
    <message>
        <source>Sent</source>
        <translation>Envoyés</translation>
    </message>
    <message>
        <source>Serial line (Modbus RTU)</source>
        <translation>Ligne série (Modbus RTU)</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>Port série</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Session</translation>
    </message>
    <message>
        <source>Session time in seconds, 83.5, or minutes and seconds, 1:23.5; then Enter (J)</source>
        <translation>Temps de la session en secondes, 83,5, ou minutes et secondes, 1:23,5 ; puis Entrée (J)</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sessions</translation>
    </message>
    <message>
        <source>Set A</source>
        <translation>Placer A</translation>
    </message>
    <message>
        <source>Set A at the cursor</source>
        <translation>Placer A au curseur</translation>
    </message>
    <message>
        <source>Set B</source>
        <translation>Placer B</translation>
    </message>
    <message>
        <source>Set B at the cursor</source>
        <translation>Placer B au curseur</translation>
    </message>
    <message>
        <source>Set it aside</source>
        <translation>Mettre de côté</translation>
    </message>
    <message>
        <source>Set the target by hand</source>
        <translation>Fixer la consigne à la main</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Réglage</translation>
    </message>
    <message>
        <source>Settled
s</source>
        <translation>Établi
s</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>Temps d'établissement</translation>
    </message>
    <message>
        <source>Share of the robot's messages of the last second that did not arrive.</source>
        <translation>Part des messages du robot de la dernière seconde qui ne sont pas arrivés.</translation>
    </message>
    <message>
        <source>Share of the vibration</source>
        <translation>Part de la vibration</translation>
    </message>
    <message>
        <source>Shift and drag changes the depth, too</source>
        <translation>Maj et glisser change aussi la profondeur</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>Afficher %1</translation>
    </message>
    <message>
        <source>Show %1 seconds</source>
        <translation>Afficher %1 secondes</translation>
    </message>
    <message>
        <source>Show 10 s</source>
        <translation>Afficher 10 s</translation>
    </message>
    <message>
        <source>Show 30 s</source>
        <translation>Afficher 30 s</translation>
    </message>
    <message>
        <source>Show 5 s</source>
        <translation>Afficher 5 s</translation>
    </message>
    <message>
        <source>Show 60 s</source>
        <translation>Afficher 60 s</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Montrer dans le dossier</translation>
    </message>
    <message>
        <source>Show only parameters that differ from the saved profile</source>
        <translation>Ne montrer que les paramètres qui diffèrent du profil enregistré</translation>
    </message>
    <message>
        <source>Show the last %1 s</source>
        <translation>Afficher les %1 dernières s</translation>
    </message>
    <message>
        <source>Show the link</source>
        <translation>Montrer la liaison</translation>
    </message>
    <message>
        <source>Show the next unread notice</source>
        <translation>Montrer le prochain avis non lu</translation>
    </message>
    <message>
        <source>Show the whole scene from this side (%1)</source>
        <translation>Montrer toute la scène de ce côté (%1)</translation>
    </message>
    <message>
        <source>Show the whole session</source>
        <translation>Afficher toute la session</translation>
    </message>
    <message>
        <source>Signal of the spectrum</source>
        <translation>Signal du spectre</translation>
    </message>
    <message>
        <source>Signal that asks for the largest duty (s_max of the thesis).</source>
        <translation>Signal qui demande le rapport cyclique maximal (s_max de la thèse).</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simulé</translation>
    </message>
    <message>
        <source>Simulated finger: %1</source>
        <translation>Doigt simulé : %1</translation>
    </message>
    <message>
        <source>Simulated or mine?</source>
        <translation>Simulé ou le mien ?</translation>
    </message>
    <message>
        <source>Simulated points, from the simulator's own truth and noise. No part was measured.</source>
        <translation>Points simulés, d'après la vérité et le bruit du simulateur. Aucune partie n'a été mesurée.</translation>
    </message>
    <message>
        <source>Simulated points.</source>
        <translation>Points simulés.</translation>
    </message>
    <message>
        <source>Simulated: %1</source>
        <translation>Simulé : %1</translation>
    </message>
    <message>
        <source>Simulated: %1. What it shows is computed in this program, not measured on a touchpad.</source>
        <translation>Simulé : %1. Ce qui est montré est calculé dans ce programme, non mesuré sur un touchpad.</translation>
    </message>
    <message>
        <source>Simulated: press on the picture, %1 deep; the wheel changes it.</source>
        <translation>Simulé : presser l'image ; profondeur %1 (molette).</translation>
    </message>
    <message>
        <source>Since then it is back. Hold Re-arm to start again.</source>
        <translation>C'est revenu depuis. Maintenir Réarmer pour recommencer.</translation>
    </message>
    <message>
        <source>Slope
per s</source>
        <translation>Pente
par s</translation>
    </message>
    <message>
        <source>Small and slow, and only while the button is held. Esc ends it as well.</source>
        <translation>Petit et lent, et seulement tant que le bouton est maintenu. Esc y met fin aussi.</translation>
    </message>
    <message>
        <source>Small video</source>
        <translation>Petite vidéo</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Souplesse</translation>
    </message>
    <message>
        <source>Something needed went missing.</source>
        <translation>Quelque chose de nécessaire est venu à manquer.</translation>
    </message>
    <message>
        <source>Spectrum of the vibration</source>
        <translation>Spectre de la vibration</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Speed of playing</source>
        <translation>Vitesse de lecture</translation>
    </message>
    <message>
        <source>Speed of the roller at full duty without load.</source>
        <translation>Vitesse du rouleau à plein rapport cyclique sans charge.</translation>
    </message>
    <message>
        <source>Spread, counts</source>
        <translation>Dispersion, pts</translation>
    </message>
    <message>
        <source>Spread, mV/V</source>
        <translation>Dispersion, mV/V</translation>
    </message>
    <message>
        <source>Stale file handle</source>
        <translation>référence de fichier périmée</translation>
    </message>
    <message>
        <source>Standard layout</source>
        <translation>Disposition standard</translation>
    </message>
    <message>
        <source>Start
s</source>
        <translation>Début
s</translation>
    </message>
    <message>
        <source>Start recording</source>
        <translation>Commencer l'enregistrement</translation>
    </message>
    <message>
        <source>Start the robot's program again.</source>
        <translation>Relancer le programme du robot.</translation>
    </message>
    <message>
        <source>Start the robot's program, or set the target by hand.</source>
        <translation>Lancer le programme du robot, ou régler la consigne à la main.</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Démarrage</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Static law between stretch angle and stiffness; interpolated uses the points below.</source>
        <translation>Loi statique entre angle d'étirement et raideur ; interpolated utilise les points qui suivent.</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Rester</translation>
    </message>
    <message>
        <source>Steady error</source>
        <translation>Erreur finale</translation>
    </message>
    <message>
        <source>Step response</source>
        <translation>Réponse à un échelon</translation>
    </message>
    <message>
        <source>Step response is being computed</source>
        <translation>La réponse à un échelon est en calcul</translation>
    </message>
    <message>
        <source>Steps clipped</source>
        <translation>Pas écrêtés</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <source>Stiffness
N/mm</source>
        <translation>Raideur
N/mm</translation>
    </message>
    <message>
        <source>Stiffness control</source>
        <translation>Commande de la raideur</translation>
    </message>
    <message>
        <source>Stiffness error, RMS: %1 % recorded, %2 % so.</source>
        <translation>Erreur de raideur, RMS : %1 % enregistrée, %2 % ainsi.</translation>
    </message>
    <message>
        <source>Stiffness is not observable while its relative uncertainty is above this.</source>
        <translation>La raideur n'est pas observable tant que son incertitude relative dépasse cette valeur.</translation>
    </message>
    <message>
        <source>Stiffness is not observable with less force than this.</source>
        <translation>La raideur n'est pas observable avec moins de force que cela.</translation>
    </message>
    <message>
        <source>Stiffness is not observable with less indentation than this.</source>
        <translation>La raideur n'est pas observable avec moins d'indentation que cela.</translation>
    </message>
    <message>
        <source>Stiffness map</source>
        <translation>Carte de raideur</translation>
    </message>
    <message>
        <source>Stiffness measured at each of those angles, rising.</source>
        <translation>Raideur mesurée à chacun de ces angles, croissante.</translation>
    </message>
    <message>
        <source>Stiffness minimum force</source>
        <translation>Force minimale</translation>
    </message>
    <message>
        <source>Stiffness minimum indentation</source>
        <translation>Indentation minimale</translation>
    </message>
    <message>
        <source>Stiffness mode</source>
        <translation>Mode de raideur</translation>
    </message>
    <message>
        <source>Stiffness pace</source>
        <translation>Rythme de la raideur</translation>
    </message>
    <message>
        <source>Stiffness relative sigma limit</source>
        <translation>Limite sigma raideur</translation>
    </message>
    <message>
        <source>Stiffness target by hand</source>
        <translation>Raideur de consigne à la main</translation>
    </message>
    <message>
        <source>Stiffness target from the robot</source>
        <translation>Raideur de consigne du robot</translation>
    </message>
    <message>
        <source>Stiffness target known</source>
        <translation>Raideur de consigne connue</translation>
    </message>
    <message>
        <source>Stiffness target while it is set by hand.</source>
        <translation>Raideur de consigne tant qu'elle est réglée à la main.</translation>
    </message>
    <message>
        <source>Stiffness the robot tells</source>
        <translation>Raideur que dit le robot</translation>
    </message>
    <message>
        <source>Stiffness, N/mm</source>
        <translation>Raideur, N/mm</translation>
    </message>
    <message>
        <source>Stiffness, measured and target</source>
        <translation>Raideur, mesurée et consigne</translation>
    </message>
    <message>
        <source>Still missing: %1</source>
        <translation>Il manque encore : %1</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Arrêter l'enregistrement</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrêté</translation>
    </message>
    <message>
        <source>Stopped by the operator; motors off.</source>
        <translation>Arrêté par l'opérateur ; moteurs coupés.</translation>
    </message>
    <message>
        <source>Stream (address)</source>
        <translation>Flux (adresse)</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Étirement</translation>
    </message>
    <message>
        <source>Stretch angles of the calibration points, rising.</source>
        <translation>Angles d'étirement des points d'étalonnage, croissants.</translation>
    </message>
    <message>
        <source>Stretch at which the resonance was found.</source>
        <translation>Étirement auquel la résonance a été trouvée.</translation>
    </message>
    <message>
        <source>Stretch, read by the encoders</source>
        <translation>Étirement, lu par les codeurs</translation>
    </message>
    <message>
        <source>Stretch, °</source>
        <translation>Étirement, °</translation>
    </message>
    <message>
        <source>Subject</source>
        <translation>Sujet</translation>
    </message>
    <message>
        <source>Subject: expected a code of letters, digits, - and _ such as S07, at most %1 characters; never a name.</source>
        <translation>Sujet : attendu un code de lettres, chiffres, - et _ comme S07, au plus %1 caractères ; jamais un nom.</translation>
    </message>
    <message>
        <source>Surface level</source>
        <translation>Niveau de la surface</translation>
    </message>
    <message>
        <source>Sweeps at two stretches, 10° apart, with an accelerometer.</source>
        <translation>Des balayages à deux étirements, à 10° l'un de l'autre, avec un accéléromètre.</translation>
    </message>
    <message>
        <source>Tag "%1": expected at most %2 characters.</source>
        <translation>Étiquette « %1 » : attendu au plus %2 caractères.</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Étiquettes</translation>
    </message>
    <message>
        <source>Tags of the session</source>
        <translation>Étiquettes de la session</translation>
    </message>
    <message>
        <source>Tags, commas between, then Enter</source>
        <translation>Étiquettes, entre virgules, puis Entrée</translation>
    </message>
    <message>
        <source>Tags: %1 are too many; at most %2.</source>
        <translation>Étiquettes : %1, c'est trop ; au plus %2.</translation>
    </message>
    <message>
        <source>Take A and B away</source>
        <translation>Enlever A et B</translation>
    </message>
    <message>
        <source>Take everything off the cloth, keep your hands away, and take the point: it lasts %1 s.</source>
        <translation>Ôtez tout du tissu, gardez les mains éloignées et prenez le point : il dure %1 s.</translation>
    </message>
    <message>
        <source>Take point</source>
        <translation>Prendre le point</translation>
    </message>
    <message>
        <source>Take simulated points</source>
        <translation>Prendre des points simulés</translation>
    </message>
    <message>
        <source>Take the cursor, A and B away</source>
        <translation>Enlever le curseur, A et B</translation>
    </message>
    <message>
        <source>Take the last point back</source>
        <translation>Retirer le dernier point</translation>
    </message>
    <message>
        <source>Take the load off the cover; check the bridge's wiring.</source>
        <translation>Retirer la charge du couvercle ; vérifier le câblage du pont.</translation>
    </message>
    <message>
        <source>Take the name %1</source>
        <translation>Prendre le nom %1</translation>
    </message>
    <message>
        <source>Take the present readings as "not touched": distance offsets and load-cell zero. Lift the finger first (Ctrl+T).</source>
        <translation>Prend les lectures présentes comme « sans contact » : décalages des distances et zéro de la cellule de charge. Lever d'abord le doigt (Ctrl+T).</translation>
    </message>
    <message>
        <source>Take the tare, or calibrate it again under Calibrate. It does not keep you from arming.</source>
        <translation>Faire la tare, ou refaire l'étalonnage sous Étalonnage. Cela n'empêche pas d'armer.</translation>
    </message>
    <message>
        <source>Take your hands off the cloth and hold the button for %1 s: the duty of each motor grows until it turns.</source>
        <translation>Ôtez les mains du tissu et tenez le bouton pendant %1 s : le rapport cyclique de chaque moteur croît jusqu'à ce qu'il tourne.</translation>
    </message>
    <message>
        <source>Take your hands off the cloth and hold the button for 16 s: both motors go to their zero at once, then by steps of %1° to %2° and back.</source>
        <translation>Ôter les mains du tissu et tenir le bouton 16 s : les deux moteurs vont aussitôt à leur zéro, puis par pas de %1° jusqu'à %2° et retour.</translation>
    </message>
    <message>
        <source>Takes the last point back.</source>
        <translation>Retire le dernier point.</translation>
    </message>
    <message>
        <source>Tare</source>
        <translation>Tare</translation>
    </message>
    <message>
        <source>Tare done; the largest offset moved by {:.2f} mm.</source>
        <translation>Tare faite ; le plus grand décalage a changé de {:.2f} mm.</translation>
    </message>
    <message>
        <source>Tare failed: {}. Keep the cloth untouched and try again.</source>
        <translation>Échec de la tare : {}. Ne pas toucher le tissu et réessayer.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Consigne</translation>
    </message>
    <message>
        <source>Target and robot motion</source>
        <translation>Consigne et mouvement du robot</translation>
    </message>
    <message>
        <source>Target by hand</source>
        <translation>Consigne à la main</translation>
    </message>
    <message>
        <source>Target from robot</source>
        <translation>Consigne du robot</translation>
    </message>
    <message>
        <source>Test, while held</source>
        <translation>Essai, tant que maintenu</translation>
    </message>
    <message>
        <source>Text file busy</source>
        <translation>le fichier est en cours d'exécution</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Texture</translation>
    </message>
    <message>
        <source>Texture and vibration</source>
        <translation>Texture et vibration</translation>
    </message>
    <message>
        <source>Texture signal</source>
        <translation>Signal de texture</translation>
    </message>
    <message>
        <source>That was the first touch. Esc or STOP switches the motors off; the manual (F1) explains the rest.</source>
        <translation>C’était le premier toucher. Esc ou STOP coupe les moteurs ; le manuel (F1) explique le reste.</translation>
    </message>
    <message>
        <source>The breakaway of both motors, and sweeps at two stretches, 10° apart, with an accelerometer.</source>
        <translation>Le décollage des deux moteurs, et des balayages à deux étirements, à 10° l'un de l'autre, avec un accéléromètre.</translation>
    </message>
    <message>
        <source>The breakaway of both motors.</source>
        <translation>Le décollage des deux moteurs.</translation>
    </message>
    <message>
        <source>The camera sees the cloth mirrored left to right.</source>
        <translation>La caméra voit le tissu en miroir de gauche à droite.</translation>
    </message>
    <message>
        <source>The classic protocol cannot tell.</source>
        <translation>Le protocole classique ne peut le dire.</translation>
    </message>
    <message>
        <source>The clock went back by {:.3f} s; that step moved nothing.</source>
        <translation>L'horloge a reculé de {:.3f} s ; ce pas n'a rien bougé.</translation>
    </message>
    <message>
        <source>The cloth follows the robot's stiffness as it comes.</source>
        <translation>Le tissu suit la raideur du robot comme elle vient.</translation>
    </message>
    <message>
        <source>The cloth is as stiff as the robot's force over your indentation. A late force shakes.</source>
        <translation>Le tissu est aussi raide que la force du robot divisée par votre indentation. Une force en retard fait trembler.</translation>
    </message>
    <message>
        <source>The cloth measures {:.2f} times as stiff as its law: the law drives alone. Check light, sensors and calibration.</source>
        <translation>Le tissu mesure {:.2f} fois la raideur de sa loi : la loi commande seule. Vérifiez lumière, capteurs et étalonnage.</translation>
    </message>
    <message>
        <source>The current values (B) are felt.</source>
        <translation>On sent les valeurs actuelles (B).</translation>
    </message>
    <message>
        <source>The curves lost %1 samples.</source>
        <translation>Les courbes ont perdu %1 échantillons.</translation>
    </message>
    <message>
        <source>The damaged profile is kept as %1. The standard values are in force.</source>
        <translation>Le profil endommagé est gardé sous le nom %1. Les valeurs standard sont en vigueur.</translation>
    </message>
    <message>
        <source>The devices are asked first. Then the session starts anew; motors stay off until you arm. The choice is remembered.</source>
        <translation>Les appareils sont d’abord interrogés. Puis la session recommence ; les moteurs restent coupés jusqu’à l’armement. Le choix est retenu.</translation>
    </message>
    <message>
        <source>The devices of last time are not there. Looked for: %1. %2.</source>
        <translation>Les appareils de la dernière fois ne sont pas là. Cherchés : %1. %2.</translation>
    </message>
    <message>
        <source>The file before is still being written; try again.</source>
        <translation>Le fichier précédent est encore en cours d'écriture ; réessayer.</translation>
    </message>
    <message>
        <source>The file begins up to 10 s before you start. Ctrl+M puts a marker.</source>
        <translation>Le fichier commence jusqu'à 10 s avant le départ. Ctrl+M place un marqueur.</translation>
    </message>
    <message>
        <source>The finger never pressed in this session.</source>
        <translation>Le doigt n'a jamais appuyé dans cette session.</translation>
    </message>
    <message>
        <source>The first encoder counts against its motor's reference (firmware of 2014 and later differ).</source>
        <translation>Le premier codeur compte à l'inverse de la référence de son moteur (les micrologiciels de 2014 et d'après diffèrent).</translation>
    </message>
    <message>
        <source>The fit and its residuals are drawn here.

To begin: %1</source>
        <translation>La courbe et ses résidus sont tracés ici.

Pour commencer : %1</translation>
    </message>
    <message>
        <source>The former session has ended; the new one begins. Motors are off.</source>
        <translation>La session précédente est finie ; la nouvelle commence. Les moteurs sont coupés.</translation>
    </message>
    <message>
        <source>The haptic loop says nothing; the last state was %1.</source>
        <translation>La boucle haptique se tait ; le dernier état était %1.</translation>
    </message>
    <message>
        <source>The language changes when the window is started again.</source>
        <translation>La langue change au prochain démarrage de la fenêtre.</translation>
    </message>
    <message>
        <source>The language stays: the file of the window's settings cannot be written.</source>
        <translation>La langue reste la même : le fichier des réglages de la fenêtre ne peut être écrit.</translation>
    </message>
    <message>
        <source>The last calibration was made by this person.</source>
        <translation>Le dernier étalonnage a été fait par cette personne.</translation>
    </message>
    <message>
        <source>The last point is taken back.</source>
        <translation>Le dernier point est retiré.</translation>
    </message>
    <message>
        <source>The layout says nothing of the curves: they stay as they are.</source>
        <translation>La disposition ne dit rien des courbes : elles restent telles quelles.</translation>
    </message>
    <message>
        <source>The layout's choice of curves cannot be read: the curves stay as they are.</source>
        <translation>Le choix de courbes de la disposition est illisible : les courbes restent telles quelles.</translation>
    </message>
    <message>
        <source>The layout's choice of these curves is not possible and was left out: %1.</source>
        <translation>Le choix de la disposition pour ces courbes est impossible et a été laissé de côté : %1.</translation>
    </message>
    <message>
        <source>The list of sessions (Ctrl+Shift+O)</source>
        <translation>La liste des sessions (Ctrl+Maj+O)</translation>
    </message>
    <message>
        <source>The model calls this unstable on any touchpad: the stretch would swing on (%1).</source>
        <translation>Le modèle le dit instable sur tout touchpad : l'étirement continuerait d'osciller (%1).</translation>
    </message>
    <message>
        <source>The model calls this unstable: the stretch would swing on (%1; the motors' angle is %2 old).</source>
        <translation>Le modèle le dit instable : l'étirement continuerait d'osciller (%1 ; l'angle des moteurs est vieux de %2).</translation>
    </message>
    <message>
        <source>The motors are off. %1 points so far.</source>
        <translation>Les moteurs sont coupés. %1 points jusqu'ici.</translation>
    </message>
    <message>
        <source>The motors are off. The sweep was not finished: its points are left out.</source>
        <translation>Les moteurs sont coupés. Le balayage n’a pas été achevé : ses points sont écartés.</translation>
    </message>
    <message>
        <source>The motors are off: %1. %2 points so far.</source>
        <translation>Les moteurs sont coupés : %1. %2 points jusqu'ici.</translation>
    </message>
    <message>
        <source>The motors are on their way.</source>
        <translation>Les moteurs sont en route.</translation>
    </message>
    <message>
        <source>The motors have not answered yet: their angle is taken to be 2 ms old, and only what no touchpad bears is asked about.</source>
        <translation>Les moteurs n'ont pas encore répondu : leur angle est supposé vieux de 2 ms, et il n'est demandé que pour ce qu'aucun touchpad ne supporte.</translation>
    </message>
    <message>
        <source>The motors move as long as this is held, by mouse or space bar, and are off when it is let go.</source>
        <translation>Les moteurs tournent tant que ce bouton est tenu, à la souris ou à la barre d'espace, et sont coupés au relâchement.</translation>
    </message>
    <message>
        <source>The motors move; let go and they are off.</source>
        <translation>Les moteurs tournent ; relâcher les coupe.</translation>
    </message>
    <message>
        <source>The motors' angle is %1 old when it is used.</source>
        <translation>L'angle des moteurs est vieux de %1 quand il est utilisé.</translation>
    </message>
    <message>
        <source>The mouse leads to %1</source>
        <translation>La souris mène à %1</translation>
    </message>
    <message>
        <source>The other session is drawn %1 s later than recorded.</source>
        <translation>L'autre session est tracée %1 s plus tard qu'enregistrée.</translation>
    </message>
    <message>
        <source>The profile could not be set aside as %1: %2.</source>
        <translation>Le profil n’a pas pu être mis de côté sous le nom %1 : %2.</translation>
    </message>
    <message>
        <source>The proposal was not taken: %1</source>
        <translation>La proposition n'a pas été prise : %1</translation>
    </message>
    <message>
        <source>The recording cannot be replayed exactly: the step gave another result the second time. The measured values are safe. Please report this fault with the file.</source>
        <translation>L'enregistrement ne peut être rejoué exactement : le pas a donné un autre résultat la seconde fois. Les valeurs mesurées sont en sûreté. Signaler ce défaut avec le fichier.</translation>
    </message>
    <message>
        <source>The recording did not close as it should. %1. What was written before is safe: Recover in Review makes it whole.</source>
        <translation>L'enregistrement ne s'est pas fermé comme il faut. %1. Ce qui était écrit avant est en sûreté : Récupérer, dans Relecture, le rend entier.</translation>
    </message>
    <message>
        <source>The recording loses samples: the computer is too busy. What is written is safe; the gap is marked in the file. Close other programs.</source>
        <translation>L'enregistrement perd des échantillons : l'ordinateur est trop occupé. Ce qui est écrit est en sûreté ; la lacune est marquée dans le fichier. Fermer les autres programmes.</translation>
    </message>
    <message>
        <source>The recovery was cancelled; %1 is as it was.</source>
        <translation>La récupération a été annulée ; %1 est resté tel quel.</translation>
    </message>
    <message>
        <source>The report stands beside the profile.</source>
        <translation>Le rapport se trouve à côté du profil.</translation>
    </message>
    <message>
        <source>The robot is chosen in the link's panel.</source>
        <translation>Le robot se choisit dans le panneau de la liaison.</translation>
    </message>
    <message>
        <source>The robot must have the same key; "fyd link keygen" makes one.</source>
        <translation>Le robot doit avoir la même clé ; « fyd link keygen » en crée une.</translation>
    </message>
    <message>
        <source>The robot's operator asks: {}.</source>
        <translation>L'opérateur du robot demande : {}.</translation>
    </message>
    <message>
        <source>The robot's stiffness is kept here. Under a finger that rests, the cloth only softens; it stiffens when you lift or move on.</source>
        <translation>La raideur du robot est gardée ici. Sous un doigt immobile, le tissu ne fait que s'assouplir ; il durcit quand vous levez le doigt ou le déplacez.</translation>
    </message>
    <message>
        <source>The saved profile cannot be read, so the devices are not opened. %1. Mend the file and start again, or set it aside and go on with the standard values.</source>
        <translation>Le profil enregistré ne peut être lu, les appareils ne sont donc pas ouverts. %1. Corriger le fichier et redémarrer, ou le mettre de côté et continuer avec les valeurs standard.</translation>
    </message>
    <message>
        <source>The saved values (A) are felt. Go back to B to change anything.</source>
        <translation>On sent les valeurs enregistrées (A). Revenir à B pour changer quelque chose.</translation>
    </message>
    <message>
        <source>The scene cannot be drawn (%1). Haptic point %2, force %3.</source>
        <translation>La scène ne peut pas être dessinée (%1). Point haptique %2, force %3.</translation>
    </message>
    <message>
        <source>The scene is being prepared.</source>
        <translation>La scène est en préparation.</translation>
    </message>
    <message>
        <source>The search was cancelled. Open the session again to look for touches.</source>
        <translation>La recherche a été annulée. Rouvrir la session pour chercher les touchers.</translation>
    </message>
    <message>
        <source>The second encoder counts against its motor's reference.</source>
        <translation>Le second codeur compte à l'inverse de la référence de son moteur.</translation>
    </message>
    <message>
        <source>The selected parameters take their saved values again</source>
        <translation>Les paramètres choisis reprennent leurs valeurs enregistrées</translation>
    </message>
    <message>
        <source>The session has ended meanwhile</source>
        <translation>La session s'est terminée entre-temps</translation>
    </message>
    <message>
        <source>The session has no devices.</source>
        <translation>La session n’a pas d’appareils.</translation>
    </message>
    <message>
        <source>The session has no devices: it is closed. Choose them beside this, and press Connect.</source>
        <translation>La session n’a pas d’appareils : elle est fermée. Les choisir à côté et presser Connecter.</translation>
    </message>
    <message>
        <source>The session is closed. %1. Choose other devices.</source>
        <translation>La session est fermée. %1. Choisir d’autres appareils.</translation>
    </message>
    <message>
        <source>The session is closed: choose devices under Devices.</source>
        <translation>La session est fermée : choisir des appareils sous Appareils.</translation>
    </message>
    <message>
        <source>The session starts anew; parameters and tare stay. Motors stay off until you arm.</source>
        <translation>La session recommence ; paramètres et tare restent. Les moteurs restent coupés jusqu'à l'armement.</translation>
    </message>
    <message>
        <source>The simulated finger leaves the cloth…</source>
        <translation>Le doigt simulé quitte le tissu…</translation>
    </message>
    <message>
        <source>The simulated finger plays it: Operate, Finger, Gesture card.</source>
        <translation>Le doigt simulé la joue : Conduite, Doigt, Carte de geste.</translation>
    </message>
    <message>
        <source>The standard uncertainty is one standard deviation, from the scatter of the points.</source>
        <translation>L'incertitude type est un écart-type, d'après la dispersion des points.</translation>
    </message>
    <message>
        <source>The station did not take the command: too many at once. Try again.</source>
        <translation>La station n'a pas pris la commande : trop à la fois. Réessayer.</translation>
    </message>
    <message>
        <source>The station did not take the target: too many commands at once. Try again.</source>
        <translation>La station n'a pas pris la consigne : trop de commandes à la fois. Réessayer.</translation>
    </message>
    <message>
        <source>The station is silent: wait until it answers.</source>
        <translation>La station se tait : attendre qu'elle réponde.</translation>
    </message>
    <message>
        <source>The step refused %1: it cannot be used now.</source>
        <translation>Le pas a refusé %1 : inutilisable en ce moment.</translation>
    </message>
    <message>
        <source>The target from above. Below, how far each mark is off. Crosses: points the others contradict.</source>
        <translation>La cible vue de dessus. Dessous, l'écart de chaque marque. Croix : points que les autres contredisent.</translation>
    </message>
    <message>
        <source>The target is out of reach; rendering the nearest, {:.3f} N/mm.</source>
        <translation>La consigne est hors de portée ; rendu de la plus proche, {:.3f} N/mm.</translation>
    </message>
    <message>
        <source>The theme changes once the motors are off: Esc would not be heard meanwhile.</source>
        <translation>Le thème change quand les moteurs sont coupés : Esc ne serait pas entendu entre-temps.</translation>
    </message>
    <message>
        <source>The touchpad answers. Calibrate its parts, so that what it shows can be trusted; motors move only while you hold a button.</source>
        <translation>Le touchpad répond. Étalonner ses parties, pour qu’on puisse se fier à ce qu’il montre ; les moteurs ne bougent que tant qu’un bouton est maintenu.</translation>
    </message>
    <message>
        <source>The touchpad is not simulated: take its points by measuring.</source>
        <translation>Le touchpad n'est pas simulé : prendre ses points en mesurant.</translation>
    </message>
    <message>
        <source>The touchpad's own</source>
        <translation>Du touchpad lui-même</translation>
    </message>
    <message>
        <source>The values are, within the tolerance stated for that.</source>
        <translation>Les valeurs le sont, dans la tolérance indiquée pour cela.</translation>
    </message>
    <message>
        <source>The whole recording</source>
        <translation>Tout l'enregistrement</translation>
    </message>
    <message>
        <source>The whole session</source>
        <translation>Toute la session</translation>
    </message>
    <message>
        <source>Theme of the system</source>
        <translation>Thème du système</translation>
    </message>
    <message>
        <source>Then hold Re-arm.</source>
        <translation>Puis maintenir Réarmer.</translation>
    </message>
    <message>
        <source>There are no values to save yet.</source>
        <translation>Il n'y a pas encore de valeurs à enregistrer.</translation>
    </message>
    <message>
        <source>There are no values yet to go to.</source>
        <translation>Il n'y a pas encore de valeurs où aller.</translation>
    </message>
    <message>
        <source>There is no parameter '%1'.</source>
        <translation>Il n'y a pas de paramètre '%1'.</translation>
    </message>
    <message>
        <source>There is nothing to accept yet: %1.</source>
        <translation>Il n'y a encore rien à accepter : %1.</translation>
    </message>
    <message>
        <source>These points are measured: discard them before you take simulated ones.</source>
        <translation>Ces points sont mesurés : les écarter avant d'en prendre de simulés.</translation>
    </message>
    <message>
        <source>These points are simulated: discard them before you measure.</source>
        <translation>Ces points sont simulés : les écarter avant de mesurer.</translation>
    </message>
    <message>
        <source>These points were measured on another touchpad: discard them before you measure on the simulated one.</source>
        <translation>Ces points ont été mesurés sur un autre touchpad : les écarter avant de mesurer sur le touchpad simulé.</translation>
    </message>
    <message>
        <source>These points were measured on the simulated touchpad: discard them before you measure on this one.</source>
        <translation>Ces points ont été mesurés sur le touchpad simulé : les écarter avant de mesurer sur celui-ci.</translation>
    </message>
    <message>
        <source>Thesis kd</source>
        <translation>Kd de la thèse</translation>
    </message>
    <message>
        <source>Thesis ki</source>
        <translation>Ki de la thèse</translation>
    </message>
    <message>
        <source>Thesis kp</source>
        <translation>Kp de la thèse</translation>
    </message>
    <message>
        <source>Thesis mode: grey values below it are the finger.</source>
        <translation>Mode thesis : les niveaux de gris inférieurs sont le doigt.</translation>
    </message>
    <message>
        <source>Thesis mode: smallest dark area that counts as a touch, in pixels of its 160 × 120 picture.</source>
        <translation>Mode thesis : plus petite aire sombre qui compte comme un toucher, en pixels de son image de 160 × 120.</translation>
    </message>
    <message>
        <source>Thesis mode: the robot goes where the finger is, with a jump at each new touch; off: each touch moves it from where it stands.</source>
        <translation>Mode thèse : le robot va où est le doigt, avec un saut à chaque nouveau toucher ; éteint : chaque toucher le déplace d'où il se trouve.</translation>
    </message>
    <message>
        <source>They are asked again by themselves: check power and cables.</source>
        <translation>Ils sont interrogés de nouveau d’eux-mêmes : vérifier l’alimentation et les câbles.</translation>
    </message>
    <message>
        <source>They are asked again by themselves: close the other program.</source>
        <translation>Ils sont interrogés de nouveau d’eux-mêmes : fermer l’autre programme.</translation>
    </message>
    <message>
        <source>This angle is taken.</source>
        <translation>Cet angle est pris.</translation>
    </message>
    <message>
        <source>This computer opens no folder from here: %1.</source>
        <translation>Cet ordinateur n'ouvre pas de dossier d'ici : %1.</translation>
    </message>
    <message>
        <source>This computer opens no folder from here: %1. Copy path takes the file's path along.</source>
        <translation>Cet ordinateur n'ouvre pas de dossier d'ici : %1. Copier le chemin emporte celui du fichier.</translation>
    </message>
    <message>
        <source>This computer's own address, HOST:PORT. The robot calls there; 0.0.0.0 hears every network.</source>
        <translation>L'adresse de cet ordinateur, HOST:PORT. Le robot y appelle ; 0.0.0.0 écoute tous les réseaux.</translation>
    </message>
    <message>
        <source>This depth is taken: press deeper or less deep, then let go and go on to the next stretch.</source>
        <translation>Cette profondeur est prise : presser plus ou moins, puis relâcher et passer à l'étirement suivant.</translation>
    </message>
    <message>
        <source>This part's points are taken by themselves while the button is held.</source>
        <translation>Les points de cette partie se prennent tout seuls tant que le bouton est tenu.</translation>
    </message>
    <message>
        <source>This robot tells no force: its stiffness is taken instead.</source>
        <translation>Ce robot ne dit pas de force : sa raideur est prise à la place.</translation>
    </message>
    <message>
        <source>This session's</source>
        <translation>De cette session</translation>
    </message>
    <message>
        <source>This source has none</source>
        <translation>Cette source n'en a pas</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Time constant of the derivative's low-pass.</source>
        <translation>Constante de temps du passe-bas du terme dérivé.</translation>
    </message>
    <message>
        <source>Time in which a motor reaches 63 % of its speed.</source>
        <translation>Temps dans lequel un moteur atteint 63 % de sa vitesse.</translation>
    </message>
    <message>
        <source>Time over which a new method, filter or gain takes over.</source>
        <translation>Temps pendant lequel une nouvelle méthode, un filtre ou un gain prend le relais.</translation>
    </message>
    <message>
        <source>Time over which the measured stiffness' noise repeats itself; auto-tune measures it.</source>
        <translation>Temps au bout duquel le bruit de la raideur mesurée se répète ; le réglage automatique le mesure.</translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation>Temps affiché</translation>
    </message>
    <message>
        <source>Time shown in seconds</source>
        <translation>Temps affiché en secondes</translation>
    </message>
    <message>
        <source>Times lost</source>
        <translation>Coupures</translation>
    </message>
    <message>
        <source>Tint what the detector takes for the finger (M)</source>
        <translation>Colore ce que le détecteur prend pour le doigt (M)</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>trop de niveaux de liens symboliques</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>trop de fichiers ouverts</translation>
    </message>
    <message>
        <source>Too many open files in system</source>
        <translation>trop de fichiers ouverts dans le système</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Top edge of the cloth in the camera's picture.</source>
        <translation>Bord supérieur du tissu dans l'image de la caméra.</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Toucher</translation>
    </message>
    <message>
        <source>Touch %1 at %2: peak force %3, peak indentation %4, stiffness %5 of %6 asked, settled after %7</source>
        <translation>Toucher %1 à %2 : force crête %3, indentation crête %4, raideur %5 sur %6 demandés, établi après %7</translation>
    </message>
    <message>
        <source>Touches</source>
        <translation>Touchers</translation>
    </message>
    <message>
        <source>Touchpad</source>
        <translation>Touchpad</translation>
    </message>
    <message>
        <source>Translation</source>
        <translation>Translation</translation>
    </message>
    <message>
        <source>Trial %1 of %2: %3.</source>
        <translation>Essai %1 sur %2 : %3.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>Réglage</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Réglage</translation>
    </message>
    <message>
        <source>Tuning panel</source>
        <translation>Panneau de réglage</translation>
    </message>
    <message>
        <source>Turn from the picture's axes to the touchpad's, counter-clockwise seen from above.</source>
        <translation>Rotation des axes de l'image à ceux du touchpad, antihoraire vue de dessus.</translation>
    </message>
    <message>
        <source>Two presses over each distance sensor, one at least %1 times as deep as the other.</source>
        <translation>Deux appuis au-dessus de chaque capteur de distance, l'un au moins %1 fois plus profond que l'autre.</translation>
    </message>
    <message>
        <source>Type a few letters of a command</source>
        <translation>Saisir quelques lettres d'une commande</translation>
    </message>
    <message>
        <source>Type a stretch and hold the button: the motors go there. Meanwhile press the cloth to three depths, each for a second; points are taken by themselves.</source>
        <translation>Saisir un étirement et tenir le bouton : les moteurs y vont. Presser pendant ce temps le tissu à trois profondeurs, une seconde chacune ; les points se prennent tout seuls.</translation>
    </message>
    <message>
        <source>UDP {}: {}: {}</source>
        <translation>UDP {} : {} : {}</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Incertitude</translation>
    </message>
    <message>
        <source>Uncertainty of the cloth's formula</source>
        <translation>Incertitude de la formule du tissu</translation>
    </message>
    <message>
        <source>Uncertainty of the contact radius share</source>
        <translation>Incertitude de la part du rayon de contact</translation>
    </message>
    <message>
        <source>Uncertainty of the tension ratio</source>
        <translation>Incertitude du rapport de tension</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Undo %1 (Ctrl+Z)</source>
        <translation>Annuler %1 (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Unit of: %1</source>
        <translation>Unité de : %1</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Inconnu</translation>
    </message>
    <message>
        <source>Upper end of %1</source>
        <translation>Borne supérieure de %1</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Utiliser</translation>
    </message>
    <message>
        <source>Use %1 as: %2</source>
        <translation>Utiliser %1 comme : %2</translation>
    </message>
    <message>
        <source>Use a preset's values</source>
        <translation>Utiliser les valeurs d'un préréglage</translation>
    </message>
    <message>
        <source>Use the chosen preset's values; one step to undo (Enter on the list)</source>
        <translation>Utiliser les valeurs du préréglage choisi ; une seule étape à annuler (Entrée sur la liste)</translation>
    </message>
    <message>
        <source>Use the new value all the same; undo takes it back</source>
        <translation>Utilise quand même la nouvelle valeur ; Annuler revient à la précédente</translation>
    </message>
    <message>
        <source>Use the proposed values; one step to undo</source>
        <translation>Utiliser les valeurs proposées ; une seule étape à annuler</translation>
    </message>
    <message>
        <source>Use the simulation</source>
        <translation>Utiliser la simulation</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Values in force and new values</source>
        <translation>Valeurs en vigueur et nouvelles valeurs</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Vibration</source>
        <translation>Vibration</translation>
    </message>
    <message>
        <source>Vibration at the finger, reckoned (%1)</source>
        <translation>Vibration au doigt, calculée (%1)</translation>
    </message>
    <message>
        <source>Vibration duty, held by the motor board</source>
        <translation>Rapport cyclique de vibration, tenu par la carte moteurs</translation>
    </message>
    <message>
        <source>Vibration: motors and cloth</source>
        <translation>Vibration : moteurs et tissu</translation>
    </message>
    <message>
        <source>Video file</source>
        <translation>Fichier vidéo</translation>
    </message>
    <message>
        <source>Video without loss</source>
        <translation>Vidéo sans perte</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>Wait until it answers; close other programs on this machine.</source>
        <translation>Attendre qu'elle réponde ; fermer les autres programmes sur cet ordinateur.</translation>
    </message>
    <message>
        <source>Waiting for a robot</source>
        <translation>En attente d'un robot</translation>
    </message>
    <message>
        <source>Waiting for the disk …</source>
        <translation>En attente du disque …</translation>
    </message>
    <message>
        <source>Waiting for the haptic loop.</source>
        <translation>En attente de la boucle haptique.</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Poids</translation>
    </message>
    <message>
        <source>Welcome. Try everything on the simulated touchpad, or connect your own. The answer is remembered and can be changed in Devices.</source>
        <translation>Bienvenue. On peut tout essayer sur le touchpad simulé, ou connecter le sien. La réponse est retenue et peut être changée dans Appareils.</translation>
    </message>
    <message>
        <source>Well</source>
        <translation>Bien</translation>
    </message>
    <message>
        <source>What differs from the saved profile</source>
        <translation>Ce qui diffère du profil enregistré</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Ce qui s'est passé</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>Et si</translation>
    </message>
    <message>
        <source>What one is used as goes into the form; Connect takes it.</source>
        <translation>Les boutons mettent l’appareil dans le formulaire ; Connecter le prend.</translation>
    </message>
    <message>
        <source>What stands in the robot's place and is touched; "fyd scene keys" shows what it may say.</source>
        <translation>Ce qui se trouve à la place du robot et que l'on touche ; « fyd scene keys » montre ce qu'il peut dire.</translation>
    </message>
    <message>
        <source>What the cloth is identified from</source>
        <translation>De quoi le tissu est identifié</translation>
    </message>
    <message>
        <source>What to do now</source>
        <translation>Que faire maintenant</translation>
    </message>
    <message>
        <source>What was asked, and what the part that holds it says of it. A value counts as confirmed only when that part has said so.</source>
        <translation>Ce qui a été demandé, et ce qu'en dit la partie qui le tient. Une valeur n'est confirmée que lorsque cette partie l'a dit.</translation>
    </message>
    <message>
        <source>What was fitted, with its standard uncertainty</source>
        <translation>Ce qui a été ajusté, avec son incertitude type</translation>
    </message>
    <message>
        <source>Where the arm is led: where the finger will be when it gets there.</source>
        <translation>Où le bras est mené : là où le doigt sera quand il y arrivera.</translation>
    </message>
    <message>
        <source>Where the finger was said to be, against where it was seen after: RMS over about a second.</source>
        <translation>Où le doigt était dit être, par rapport à où il a été vu ensuite : RMS sur environ une seconde.</translation>
    </message>
    <message>
        <source>Where the newest touch leads the arm by itself: x, y, z.</source>
        <translation>Où le toucher le plus récent mène le bras à lui seul : x, y, z.</translation>
    </message>
    <message>
        <source>Whether the way to the finger was identified; the constants below are guesses otherwise.</source>
        <translation>Si le chemin jusqu'au doigt a été identifié ; sinon les constantes ci-dessous sont des suppositions.</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Qui</translation>
    </message>
    <message>
        <source>Who measured</source>
        <translation>Qui a mesuré</translation>
    </message>
    <message>
        <source>Who measured? Write your name at the right, then accept.</source>
        <translation>Qui a mesuré ? Écrire le nom à droite, puis accepter.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Width of the cloth in the camera's picture.</source>
        <translation>Largeur du tissu dans l'image de la caméra.</translation>
    </message>
    <message>
        <source>Words of the name, the identifier, the help or the group (Ctrl+F); Enter goes to the first that is found</source>
        <translation>Des mots du nom, de l'identifiant, de l'aide ou du groupe (Ctrl+F) ; Entrée mène au premier trouvé</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Écrire</translation>
    </message>
    <message>
        <source>Write a note at the cursor</source>
        <translation>Écrire une note au curseur</translation>
    </message>
    <message>
        <source>Writes the new values with their record, and begins the session anew with them.</source>
        <translation>Écrit les nouvelles valeurs avec leur procès-verbal, et recommence la session avec elles.</translation>
    </message>
    <message>
        <source>Writes this part's last calibration, before and after, as a PDF beside the profile.</source>
        <translation>Écrit le dernier étalonnage de cette partie, avant et après, en PDF à côté du profil.</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Écriture de %1</translation>
    </message>
    <message>
        <source>a code, such as S07; never a name</source>
        <translation>un code, comme S07 ; jamais un nom</translation>
    </message>
    <message>
        <source>a condition without a name</source>
        <translation>une condition sans nom</translation>
    </message>
    <message>
        <source>a cycle</source>
        <translation>un cycle</translation>
    </message>
    <message>
        <source>a folder has none</source>
        <translation>un dossier n'en a pas</translation>
    </message>
    <message>
        <source>a key that no record has</source>
        <translation>une clé qu'aucune entrée n'a</translation>
    </message>
    <message>
        <source>a line for each axis</source>
        <translation>une droite par axe</translation>
    </message>
    <message>
        <source>a line for each encoder</source>
        <translation>une droite par codeur</translation>
    </message>
    <message>
        <source>a line of at most {} bytes</source>
        <translation>une ligne d'au plus {} octets</translation>
    </message>
    <message>
        <source>a list of numbers, each from {} to {}{}</source>
        <translation>une liste de nombres, chacun de {} à {}{}</translation>
    </message>
    <message>
        <source>a motor stands beyond control.motor_limit_deg: check the encoder's zero</source>
        <translation>un moteur est au-delà de control.motor_limit_deg : vérifier le zéro du codeur</translation>
    </message>
    <message>
        <source>a number from {} to {}{}</source>
        <translation>un nombre de {} à {}{}</translation>
    </message>
    <message>
        <source>a number with a point, or nan</source>
        <translation>un nombre avec un point, ou nan</translation>
    </message>
    <message>
        <source>a parameter</source>
        <translation>un paramètre</translation>
    </message>
    <message>
        <source>a picture is {} × {} px, those before {} × {}; choose a time with one size</source>
        <translation>une image fait {} × {} px, les précédentes {} × {} ; choisir un temps d'une seule taille</translation>
    </message>
    <message>
        <source>a picture of {} x {} pixels: too large</source>
        <translation>une image de {} x {} pixels : trop grande</translation>
    </message>
    <message>
        <source>a polygon has vertex {}; expected one of the {} of this {} file</source>
        <translation>un polygone a le sommet {} ; attendu l'un des {} de ce fichier {}</translation>
    </message>
    <message>
        <source>a prediction of {} ms at most: expected 0 to 1000</source>
        <translation>une prédiction de {} ms au plus : attendu 0 à 1000</translation>
    </message>
    <message>
        <source>a reason that this program does not know</source>
        <translation>une raison que ce programme ne connaît pas</translation>
    </message>
    <message>
        <source>a recording</source>
        <translation>un enregistrement</translation>
    </message>
    <message>
        <source>a recording is being written</source>
        <translation>un enregistrement est en cours</translation>
    </message>
    <message>
        <source>a recording of format {}; this program reads format {}</source>
        <translation>un enregistrement au format {} ; ce programme lit le format {}</translation>
    </message>
    <message>
        <source>a scene of format {}; this program reads format {}</source>
        <translation>une scène de format {} ; ce programme lit le format {}</translation>
    </message>
    <message>
        <source>a scene of {} bodies with the contacts of {}</source>
        <translation>une scène de {} corps avec les contacts de {}</translation>
    </message>
    <message>
        <source>a second</source>
        <translation>par seconde</translation>
    </message>
    <message>
        <source>a second robot</source>
        <translation>un second robot</translation>
    </message>
    <message>
        <source>a sensor is outside its span</source>
        <translation>un capteur est hors de sa plage</translation>
    </message>
    <message>
        <source>a state of a program before revision a4d2b6a</source>
        <translation>l'état d'un programme antérieur à la révision a4d2b6a</translation>
    </message>
    <message>
        <source>a stream has none</source>
        <translation>un flux n'en a pas</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texte</translation>
    </message>
    <message>
        <source>a touchpad that is not known</source>
        <translation>un touchpad inconnu</translation>
    </message>
    <message>
        <source>a turning motor has %1 % of its breakaway</source>
        <translation>un moteur qui tourne a %1 % de son décollage</translation>
    </message>
    <message>
        <source>a value is not finite</source>
        <translation>une valeur n'est pas finie</translation>
    </message>
    <message>
        <source>a video file has none</source>
        <translation>un fichier vidéo n'en a pas</translation>
    </message>
    <message>
        <source>a weight is negative</source>
        <translation>un poids est négatif</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un nombre entier</translation>
    </message>
    <message>
        <source>a whole number from {} to {}{}</source>
        <translation>un nombre entier de {} à {}{}</translation>
    </message>
    <message>
        <source>a wrong tare of %1 ± %2 is taken into account</source>
        <translation>une tare fausse de %1 ± %2 est prise en compte</translation>
    </message>
    <message>
        <source>aborted</source>
        <translation>interrompue</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>accélération</translation>
    </message>
    <message>
        <source>acceleration limit {} mm/s²: expected 10 to 100000</source>
        <translation>limite d'accélération {} mm/s² : attendu de 10 à 100000</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>acceptée</translation>
    </message>
    <message>
        <source>adaptive follows uneven and changing light; thesis is the printed algorithm.</source>
        <translation>adaptive suit une lumière inégale et changeante ; thesis est l'algorithme imprimé.</translation>
    </message>
    <message>
        <source>adc rises from {:.0f} at {:g} mm to {:.0f} at {:g} mm, but a farther target must read less: measure both again</source>
        <translation>adc monte de {:.0f} à {:g} mm à {:.0f} à {:g} mm, mais une cible plus éloignée doit donner moins : mesurer de nouveau les deux</translation>
    </message>
    <message>
        <source>adc rises from {:.0f} at {:g} mm to {:.0f} at {:g} mm, but a farther target must read less: measure both again, and leave out distances the sensor is too near for</source>
        <translation>adc monte de {:.0f} à {:g} mm à {:.0f} à {:g} mm, mais une cible plus éloignée doit donner moins : mesurer de nouveau les deux, et laisser de côté les distances trop proches pour le capteur</translation>
    </message>
    <message>
        <source>add weights between {:.3g} and {:.3g} N</source>
        <translation>ajouter des poids entre {:.3g} et {:.3g} N</translation>
    </message>
    <message>
        <source>address "{}": "{}" is not an {} address (names other than localhost are not looked up)</source>
        <translation>adresse « {} » : « {} » n'est pas une adresse {} (les noms autres que localhost ne sont pas cherchés)</translation>
    </message>
    <message>
        <source>address "{}": an IPv6 address stands in brackets, such as [::1]:3490</source>
        <translation>adresse « {} » : une adresse IPv6 se met entre crochets, comme [::1]:3490</translation>
    </message>
    <message>
        <source>address "{}": no port; expected HOST:PORT such as 127.0.0.1:3490 or [::1]:3490</source>
        <translation>adresse « {} » : pas de port ; attendu HOST:PORT comme 127.0.0.1:3490 ou [::1]:3490</translation>
    </message>
    <message>
        <source>address "{}": only a link-local address (fe80::…) has an interface after %</source>
        <translation>adresse "{}" : seule une adresse de lien local (fe80::…) a une interface après %</translation>
    </message>
    <message>
        <source>address "{}": port "{}" is not a whole number from 0 to 65535</source>
        <translation>adresse « {} » : le port « {} » n'est pas un nombre entier de 0 à 65535</translation>
    </message>
    <message>
        <source>address "{}": there is no network interface "{}"</source>
        <translation>adresse "{}" : il n'y a pas d'interface réseau "{}"</translation>
    </message>
    <message>
        <source>again and again</source>
        <translation>en boucle</translation>
    </message>
    <message>
        <source>ageing: %1</source>
        <translation>vieillit : %1</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>alarme</translation>
    </message>
    <message>
        <source>all back to the saved values</source>
        <translation>retour à toutes les valeurs enregistrées</translation>
    </message>
    <message>
        <source>all four edges are held</source>
        <translation>les quatre bords sont tenus</translation>
    </message>
    <message>
        <source>all parts</source>
        <translation>toutes les parties</translation>
    </message>
    <message>
        <source>all points at {} V</source>
        <translation>tous les points à {} V</translation>
    </message>
    <message>
        <source>all presses are about equally deep, so a wrong tare cannot be told from stiffness: press to different depths</source>
        <translation>toutes les pressions ont à peu près la même profondeur, une tare fausse ne se distingue donc pas de la raideur : presser à des profondeurs différentes</translation>
    </message>
    <message>
        <source>an HDF5 file, but not a recording of the console</source>
        <translation>un fichier HDF5, mais pas un enregistrement de la console</translation>
    </message>
    <message>
        <source>an HDF5 file, but not a recording of the console, or its first bytes are damaged</source>
        <translation>un fichier HDF5, mais pas un enregistrement de la console, ou ses premiers octets sont endommagés</translation>
    </message>
    <message>
        <source>an answer of another unit</source>
        <translation>une réponse d'une autre unité</translation>
    </message>
    <message>
        <source>an answer that does not fit the question</source>
        <translation>une réponse qui ne correspond pas à la question</translation>
    </message>
    <message>
        <source>an answer with a wrong checksum; is the speed right and the line terminated?</source>
        <translation>une réponse à somme de contrôle erronée ; la vitesse est-elle juste et la ligne terminée ?</translation>
    </message>
    <message>
        <source>an axis spreads by {:.3f} g; expected at most {:g}: it moves: put the robot to rest</source>
        <translation>un axe varie de {:.3f} g ; attendu au plus {:g} : il bouge : mettre le robot au repos</translation>
    </message>
    <message>
        <source>an exception with a number that Modbus does not have</source>
        <translation>une exception dont le numéro n'existe pas dans Modbus</translation>
    </message>
    <message>
        <source>an unknown state</source>
        <translation>un état inconnu</translation>
    </message>
    <message>
        <source>an unknown that no point tells anything of</source>
        <translation>une inconnue dont aucun point ne dit rien</translation>
    </message>
    <message>
        <source>and {} more</source>
        <translation>et {} de plus</translation>
    </message>
    <message>
        <source>angles, indentations and forces differ in number</source>
        <translation>angles, indentations et forces ne sont pas en même nombre</translation>
    </message>
    <message>
        <source>another console</source>
        <translation>une autre console</translation>
    </message>
    <message>
        <source>another console, process %1 on %2</source>
        <translation>une autre console, processus %1 sur %2</translation>
    </message>
    <message>
        <source>another file</source>
        <translation>un autre fichier</translation>
    </message>
    <message>
        <source>another program has made the file shorter while it was written</source>
        <translation>un autre programme a raccourci le fichier pendant qu'il était écrit</translation>
    </message>
    <message>
        <source>another robot is served</source>
        <translation>un autre robot est servi</translation>
    </message>
    <message>
        <source>answers missing</source>
        <translation>réponses manquantes</translation>
    </message>
    <message>
        <source>any text of the header may be wrong: {}</source>
        <translation>tout texte de l'en-tête peut être faux : {}</translation>
    </message>
    <message>
        <source>area</source>
        <translation>aire</translation>
    </message>
    <message>
        <source>arithmetic {}: expected 1 or more</source>
        <translation>arithmétique {} : attendu 1 ou plus</translation>
    </message>
    <message>
        <source>asked for {:.0f} %, the camera took {:.0f} %</source>
        <translation>demandé {:.0f} %, la caméra a pris {:.0f} %</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>à %1</translation>
    </message>
    <message>
        <source>at %1: %2, damping %3, %4 % left</source>
        <translation>à %1 : %2, amortissement %3, reste %4 %</translation>
    </message>
    <message>
        <source>at edge</source>
        <translation>au bord</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>au repos</translation>
    </message>
    <message>
        <source>at rest it measures {:.3f} g; expected 1 within {:g}: check the counts per g of the sensor</source>
        <translation>au repos il mesure {:.3f} g ; attendu 1 à {:g} près : vérifier les points par g du capteur</translation>
    </message>
    <message>
        <source>at rest {:.4f} g, spread {:.4f} g</source>
        <translation>au repos {:.4f} g, dispersion {:.4f} g</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>auto-tune</source>
        <translation>réglage automatique</translation>
    </message>
    <message>
        <source>auto-tune: cancelled</source>
        <translation>réglage automatique : annulé</translation>
    </message>
    <message>
        <source>auto-tune: no time constant up to {} s keeps gain margin {} and phase margin {}° (dead time {:.3f} s, lag {:.3f} s, noise {:.1f} %)</source>
        <translation>réglage automatique : aucune constante de temps jusqu'à {} s ne garde la marge de gain {} et la marge de phase {}° (temps mort {:.3f} s, retard {:.3f} s, bruit {:.1f} %)</translation>
    </message>
    <message>
        <source>average more readings at each distance, target square to the sensor</source>
        <translation>moyenner plus de lectures à chaque distance, cible d'équerre avec le capteur</translation>
    </message>
    <message>
        <source>axes "{}": expected x, y and z once each, such as -y,-x,z</source>
        <translation>axes « {} » : attendu x, y et z une fois chacun, comme -y,-x,z</translation>
    </message>
    <message>
        <source>back to the saved values</source>
        <translation>retour aux valeurs enregistrées</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>mauvaise</translation>
    </message>
    <message>
        <source>before a handshake</source>
        <translation>avant une poignée de main</translation>
    </message>
    <message>
        <source>being recorded</source>
        <translation>en cours d'enregistrement</translation>
    </message>
    <message>
        <source>being written: %1</source>
        <translation>en cours d'écriture : %1</translation>
    </message>
    <message>
        <source>black picture</source>
        <translation>image noire</translation>
    </message>
    <message>
        <source>blurred</source>
        <translation>flou</translation>
    </message>
    <message>
        <source>bookmark</source>
        <translation>signet</translation>
    </message>
    <message>
        <source>border of a soft body is {}; expected between 0 and 1</source>
        <translation>border d'un corps mou est {} ; attendu entre 0 et 1</translation>
    </message>
    <message>
        <source>both ends hold the same scene</source>
        <translation>les deux extrémités ont la même scène</translation>
    </message>
    <message>
        <source>breakaway</source>
        <translation>décollage</translation>
    </message>
    <message>
        <source>breakaway of each motor; resonance of the cloth under a finger</source>
        <translation>décollage de chaque moteur ; résonance du tissu sous un doigt</translation>
    </message>
    <message>
        <source>brightness</source>
        <translation>luminosité</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>par %1</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>à la main</translation>
    </message>
    <message>
        <source>calibrated on {}, and this is {}: the defaults are used instead ({})</source>
        <translation>étalonné sur : {} ; celui-ci est : {}. Les valeurs par défaut servent à la place ({})</translation>
    </message>
    <message>
        <source>calibrated {} days ago: repeat it</source>
        <translation>étalonné il y a {} jours : à refaire</translation>
    </message>
    <message>
        <source>calibrated {} days ago: repeat it soon</source>
        <translation>étalonné il y a {} jours : à refaire bientôt</translation>
    </message>
    <message>
        <source>calibrated {} days in the future: the computer's clock was or is wrong</source>
        <translation>étalonné {} jours dans le futur : l'horloge de l'ordinateur était ou est fausse</translation>
    </message>
    <message>
        <source>calibration points not accepted: %1</source>
        <translation>points d'étalonnage non acceptés : %1</translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>caméra %1</translation>
    </message>
    <message>
        <source>camera '{}': no such file or folder; expected a device number, a path such as /dev/video0, id=SERIAL, a video file, a folder of pictures or a stream's URL</source>
        <translation>caméra '{}' : aucun fichier ou dossier de ce nom ; attendu un numéro d'appareil, un chemin comme /dev/video0, id=SERIAL, un fichier vidéo, un dossier d'images ou l'URL d'un flux</translation>
    </message>
    <message>
        <source>camera device</source>
        <translation>caméra (appareil)</translation>
    </message>
    <message>
        <source>camera device '{}'</source>
        <translation>appareil de prise de vue '{}'</translation>
    </message>
    <message>
        <source>camera device '{}': there is none; capture devices found: {}</source>
        <translation>caméra '{}' : elle n'existe pas ; périphériques de capture trouvés : {}</translation>
    </message>
    <message>
        <source>camera device {}: there is no {}; capture devices found: {}</source>
        <translation>caméra {} : il n'y a pas de {} ; périphériques de capture trouvés : {}</translation>
    </message>
    <message>
        <source>camera folder '{}': no pictures; expected {}</source>
        <translation>dossier de la caméra '{}' : pas d'images ; attendu {}</translation>
    </message>
    <message>
        <source>camera folder '{}': {}</source>
        <translation>dossier de la caméra '{}' : {}</translation>
    </message>
    <message>
        <source>camera folder: {}</source>
        <translation>dossier de la caméra : {}</translation>
    </message>
    <message>
        <source>camera stream '{}'</source>
        <translation>flux de caméra '{}'</translation>
    </message>
    <message>
        <source>camera: none given; only the simulated touchpad has a simulated camera</source>
        <translation>caméra : aucune donnée ; seul le touchpad simulé a une caméra simulée</translation>
    </message>
    <message>
        <source>camera: {}</source>
        <translation>caméra : {}</translation>
    </message>
    <message>
        <source>cancelled before it was done</source>
        <translation>annulé avant la fin</translation>
    </message>
    <message>
        <source>cannot be judged on held-out distances</source>
        <translation>ne peut pas être jugée sur des distances mises de côté</translation>
    </message>
    <message>
        <source>cannot be read back</source>
        <translation>ne peut être relu</translation>
    </message>
    <message>
        <source>cannot be set to non-blocking</source>
        <translation>ne peut pas être rendu non bloquant</translation>
    </message>
    <message>
        <source>cannot listen</source>
        <translation>écoute impossible</translation>
    </message>
    <message>
        <source>cannot listen, another program holds the port</source>
        <translation>écoute impossible, un autre programme occupe le port</translation>
    </message>
    <message>
        <source>cannot open a socket</source>
        <translation>ne peut pas ouvrir de socket</translation>
    </message>
    <message>
        <source>cannot tell its own address</source>
        <translation>ne peut pas dire sa propre adresse</translation>
    </message>
    <message>
        <source>catalogue 'sqlite:{}': expected a file</source>
        <translation>catalogue 'sqlite:{}' : attendu un fichier</translation>
    </message>
    <message>
        <source>catalogue '{}': a path with a quotation mark is not possible</source>
        <translation>catalogue '{}' : un chemin avec un guillemet n'est pas possible</translation>
    </message>
    <message>
        <source>catalogue '{}': expected sqlite:PATH, postgresql:host=… dbname=… user=…, or none</source>
        <translation>catalogue '{}' : attendu sqlite:PATH, postgresql:host=… dbname=… user=…, ou none</translation>
    </message>
    <message>
        <source>catalogue '{}://…': expected sqlite:PATH, postgresql:host=… dbname=… user=…, or none</source>
        <translation>catalogue '{}://…' : attendu sqlite:CHEMIN, postgresql:host=… dbname=… user=…, ou none</translation>
    </message>
    <message>
        <source>catalogue: libpq cannot read the words after '{}'; expected host=… dbname=… user=…</source>
        <translation>catalogue : libpq ne peut pas lire les mots après '{}' ; attendu host=… dbname=… user=…</translation>
    </message>
    <message>
        <source>catalogue: the word carries a password, which logs and lists of processes would show; put it into ~/.pgpass (mode 600) instead</source>
        <translation>catalogue : le mot contient un mot de passe, que journaux et listes de processus montreraient ; le mettre plutôt dans ~/.pgpass (mode 600)</translation>
    </message>
    <message>
        <source>changed and not saved: %1</source>
        <translation>modifiés et non enregistrés : %1</translation>
    </message>
    <message>
        <source>changed and not saved: %1 and %2 more</source>
        <translation>modifiés et non enregistrés : %1 et %2 autres</translation>
    </message>
    <message>
        <source>changed since it was calibrated %1 days ago</source>
        <translation>changé depuis l'étalonnage il y a %1 jours</translation>
    </message>
    <message>
        <source>changed since it was calibrated today</source>
        <translation>changé depuis l'étalonnage d'aujourd'hui</translation>
    </message>
    <message>
        <source>changed since it was calibrated yesterday</source>
        <translation>changé depuis l'étalonnage d'hier</translation>
    </message>
    <message>
        <source>check the touchpad's connection</source>
        <translation>vérifier la connexion du touchpad</translation>
    </message>
    <message>
        <source>check the weights, and that nothing rubs on the cell</source>
        <translation>vérifier les poids, et que rien ne frotte sur la cellule</translation>
    </message>
    <message>
        <source>chirp</source>
        <translation>chirp</translation>
    </message>
    <message>
        <source>classic robot, listening on {}</source>
        <translation>robot classique, en écoute sur {}</translation>
    </message>
    <message>
        <source>classic, not secured</source>
        <translation>classique, non sécurisé</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>écrêté</translation>
    </message>
    <message>
        <source>clock</source>
        <translation>horloge</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>fermé</translation>
    </message>
    <message>
        <source>closed loop: the recording does not say how the cloth answers: {}</source>
        <translation>boucle fermée : l'enregistrement ne dit pas comment le tissu répond : {}</translation>
    </message>
    <message>
        <source>closing</source>
        <translation>en fermeture</translation>
    </message>
    <message>
        <source>cloth table: "{}" where "{}" was expected</source>
        <translation>table du tissu : "{}" où "{}" était attendu</translation>
    </message>
    <message>
        <source>cloth table: does not begin with "fyd-cloth 1"</source>
        <translation>table du tissu : ne commence pas par "fyd-cloth 1"</translation>
    </message>
    <message>
        <source>cloth table: ends before "{}"</source>
        <translation>table du tissu : finit avant "{}"</translation>
    </message>
    <message>
        <source>cloth table: expected two half sides, one distance and two reference stiffnesses, all above 0</source>
        <translation>table du tissu : attendu deux demi-côtés, une distance et deux raideurs de référence, tous supérieurs à 0</translation>
    </message>
    <message>
        <source>cloth table: no line "finger"</source>
        <translation>table du tissu : pas de ligne "finger"</translation>
    </message>
    <message>
        <source>cloth table: shape: expected one number, 3 … {}</source>
        <translation>table du tissu : shape : attendu un nombre, 3 … {}</translation>
    </message>
    <message>
        <source>cloth table: x from 0, depth above 0</source>
        <translation>table du tissu : x à partir de 0, profondeur supérieure à 0</translation>
    </message>
    <message>
        <source>cloth table: {} holds something that is no number</source>
        <translation>table du tissu : {} contient quelque chose qui n'est pas un nombre</translation>
    </message>
    <message>
        <source>cloth table: {} holds {}, expected finite numbers</source>
        <translation>table du tissu : {} contient {}, attendu des nombres finis</translation>
    </message>
    <message>
        <source>cloth table: {}: expected 2 … {} rising numbers</source>
        <translation>table du tissu : {} : attendu 2 … {} nombres croissants</translation>
    </message>
    <message>
        <source>cloth table: {}: {} of {} numbers</source>
        <translation>table du tissu : {} : {} nombres sur {}</translation>
    </message>
    <message>
        <source>command</source>
        <translation>commande</translation>
    </message>
    <message>
        <source>commanded</source>
        <translation>commandé</translation>
    </message>
    <message>
        <source>commanded joint</source>
        <translation>articulation commandée</translation>
    </message>
    <message>
        <source>commanded joint plus its offset</source>
        <translation>articulation commandée plus son décalage</translation>
    </message>
    <message>
        <source>commands and counts differ in number, or there are none</source>
        <translation>commandes et points des codeurs ne sont pas en même nombre, ou il n'y en a pas</translation>
    </message>
    <message>
        <source>commit {} of {}</source>
        <translation>validation {} sur {}</translation>
    </message>
    <message>
        <source>compressed bytes are damaged ({})</source>
        <translation>les octets compressés sont endommagés ({})</translation>
    </message>
    <message>
        <source>condition '{}' is given twice</source>
        <translation>la condition '{}' est donnée deux fois</translation>
    </message>
    <message>
        <source>condition number {:.3g}</source>
        <translation>conditionnement {:.3g}</translation>
    </message>
    <message>
        <source>confirmed</source>
        <translation>confirmé</translation>
    </message>
    <message>
        <source>connections</source>
        <translation>connexions</translation>
    </message>
    <message>
        <source>contact '{}': this program does not know it</source>
        <translation>contact '{}' : ce programme ne le connaît pas</translation>
    </message>
    <message>
        <source>contact and membrane use the shape of the pushed cloth and a Kalman filter, contact with the area that the camera sees; thesis a plane, 0.8/0.2 and a 2 mm gate.</source>
        <translation>contact et membrane utilisent la forme du tissu pressé et un filtre de Kalman, contact avec l'aire que voit la caméra ; thesis un plan, 0,8/0,2 et un seuil de 2 mm.</translation>
    </message>
    <message>
        <source>contrast</source>
        <translation>contraste</translation>
    </message>
    <message>
        <source>control.law_angle_deg: {} points; expected at least 2</source>
        <translation>control.law_angle_deg : {} points ; attendu au moins 2</translation>
    </message>
    <message>
        <source>control.law_stiffness_N_per_mm: {} values for {} angles; expected one for each</source>
        <translation>control.law_stiffness_N_per_mm : {} valeurs pour {} angles ; attendu une pour chacun</translation>
    </message>
    <message>
        <source>control.law_stiffness_N_per_mm: {}; expected above 0</source>
        <translation>control.law_stiffness_N_per_mm : {} ; attendu au-dessus de 0</translation>
    </message>
    <message>
        <source>control.travel_maximum_deg = {}: expected more than control.travel_minimum_deg = {}</source>
        <translation>control.travel_maximum_deg = {} : attendu plus que control.travel_minimum_deg = {}</translation>
    </message>
    <message>
        <source>cookie</source>
        <translation>cookie</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>points</translation>
    </message>
    <message>
        <source>counts against its motor</source>
        <translation>compte à l'envers de son moteur</translation>
    </message>
    <message>
        <source>counts with its motor</source>
        <translation>compte comme son moteur</translation>
    </message>
    <message>
        <source>coupling "{}": expected one of {}</source>
        <translation>couplage "{}" : un parmi {} attendu</translation>
    </message>
    <message>
        <source>current {}</source>
        <translation>courant {}</translation>
    </message>
    <message>
        <source>curve: %1</source>
        <translation>courbe : %1</translation>
    </message>
    <message>
        <source>cut short: its last {} of {} bytes are missing</source>
        <translation>tronqué : ses {} derniers octets sur {} manquent</translation>
    </message>
    <message>
        <source>dB re 1 m/s²</source>
        <translation>dB réf. 1 m/s²</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>endommagé</translation>
    </message>
    <message>
        <source>damaged pictures</source>
        <translation>images endommagées</translation>
    </message>
    <message>
        <source>damaged: {} compressed bytes do not give the {} they should</source>
        <translation>endommagé : {} octets compressés ne donnent pas les {} qu'ils devraient</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>amortissement</translation>
    </message>
    <message>
        <source>dashed</source>
        <translation>tirets</translation>
    </message>
    <message>
        <source>days left</source>
        <translation>jours restants</translation>
    </message>
    <message>
        <source>deadband {} %: expected 0 (none) … 100</source>
        <translation>bande morte {} % : attendu de 0 (aucune) à 100</translation>
    </message>
    <message>
        <source>default %1</source>
        <translation>par défaut %1</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>°</translation>
    </message>
    <message>
        <source>delay {} ms: expected 0 … {}</source>
        <translation>retard {} ms : 0 … {} attendu</translation>
    </message>
    <message>
        <source>deleting of preset %1</source>
        <translation>suppression du préréglage %1</translation>
    </message>
    <message>
        <source>device restarts</source>
        <translation>redémarrages de l'appareil</translation>
    </message>
    <message>
        <source>device test '{}': {}</source>
        <translation>essai de l'appareil '{}' : {}</translation>
    </message>
    <message>
        <source>device test {}: no test has this number</source>
        <translation>essai d'appareil {} : aucun essai ne porte ce numéro</translation>
    </message>
    <message>
        <source>device test: the session is closed</source>
        <translation>essai de l'appareil : la session est fermée</translation>
    </message>
    <message>
        <source>device {}: none is plugged in; {} holds {}</source>
        <translation>appareil {} : aucun n'est branché ; {} contient {}</translation>
    </message>
    <message>
        <source>device {}: {} fit: {}; name more of the one that is meant</source>
        <translation>appareil {} : {} conviennent : {} ; préciser lequel est voulu</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>diffère</translation>
    </message>
    <message>
        <source>disconnect</source>
        <translation>déconnecter</translation>
    </message>
    <message>
        <source>distance readings missing or too old</source>
        <translation>lectures de distance absentes ou trop vieilles</translation>
    </message>
    <message>
        <source>distance sensor {} did not read in any press</source>
        <translation>le capteur de distance {} n'a rien lu dans aucun appui</translation>
    </message>
    <message>
        <source>distance sensor {} does not read: look under Devices</source>
        <translation>le capteur de distance {} ne lit pas : voir dans Appareils</translation>
    </message>
    <message>
        <source>distance sensor {} reads {:.0f} counts, outside its span: look whether something stands before it</source>
        <translation>le capteur de distance {} lit {:.0f} points, hors de sa plage : voir si quelque chose est devant</translation>
    </message>
    <message>
        <source>distances to the untouched cloth {} mm, spread {:.2f} mm; force {:.3f} N</source>
        <translation>distances au tissu non touché {} mm, dispersion {:.2f} mm ; force {:.3f} N</translation>
    </message>
    <message>
        <source>does not fall over its whole span</source>
        <translation>ne décroît pas sur toute sa plage</translation>
    </message>
    <message>
        <source>does not settle</source>
        <translation>ne s'établit pas</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fait</translation>
    </message>
    <message>
        <source>dotted</source>
        <translation>pointillé</translation>
    </message>
    <message>
        <source>drift from first to last point %1 ± %2</source>
        <translation>dérive du premier au dernier point %1 ± %2</translation>
    </message>
    <message>
        <source>duration {} s: expected 0 or more</source>
        <translation>durée {} s : attendu 0 ou plus</translation>
    </message>
    <message>
        <source>each ±%1 %2</source>
        <translation>chacun ±%1 %2</translation>
    </message>
    <message>
        <source>encoder %1: %2, zero at %3 counts, swept from %4 to %5</source>
        <translation>codeur %1 : %2, zéro à %3 points, balayé de %4 à %5</translation>
    </message>
    <message>
        <source>encoder counts {}, expected 0 to {}</source>
        <translation>points des codeurs {}, attendus de 0 à {}</translation>
    </message>
    <message>
        <source>encoder {}</source>
        <translation>codeur {}</translation>
    </message>
    <message>
        <source>encoder {} jumped by {:.0f}° in {:.0f} ms: check its magnet and cable, then arm again</source>
        <translation>le codeur {} a sauté de {:.0f}° en {:.0f} ms : vérifier son aimant et son câble, puis armer de nouveau</translation>
    </message>
    <message>
        <source>encoder {} stands still although its motor was sent {:.0f}° further: check the motors' supply and the encoder's cable, then arm again</source>
        <translation>le codeur {} reste immobile bien que son moteur ait été envoyé {:.0f}° plus loin : vérifier l'alimentation des moteurs et le câble du codeur, puis armer de nouveau</translation>
    </message>
    <message>
        <source>ended: a motor did not follow its commanded angle; check its encoder and that it can turn</source>
        <translation>terminé : un moteur n'a pas suivi l'angle commandé ; vérifier son codeur et qu'il peut tourner</translation>
    </message>
    <message>
        <source>ended: the button was released</source>
        <translation>terminé : le bouton a été relâché</translation>
    </message>
    <message>
        <source>ended: the haptic loop stood still</source>
        <translation>terminé : la boucle haptique s'est arrêtée</translation>
    </message>
    <message>
        <source>ended: the session was stopped or armed</source>
        <translation>terminé : la session a été arrêtée ou armée</translation>
    </message>
    <message>
        <source>ended: the session's state changed</source>
        <translation>terminé : l'état de la session a changé</translation>
    </message>
    <message>
        <source>error of the fit %1</source>
        <translation>erreur de l'ajustement %1</translation>
    </message>
    <message>
        <source>event</source>
        <translation>événement</translation>
    </message>
    <message>
        <source>exception 10: the gateway has no path to it</source>
        <translation>exception 10 : la passerelle n'a pas de chemin vers lui</translation>
    </message>
    <message>
        <source>exception 11: the gateway gets no answer from it; is it switched on?</source>
        <translation>exception 11 : la passerelle ne reçoit pas de réponse ; est-il allumé ?</translation>
    </message>
    <message>
        <source>exception 1: it does not know this function; is it a touchpad with this register map?</source>
        <translation>exception 1 : il ne connaît pas cette fonction ; est-ce un touchpad avec cette table de registres ?</translation>
    </message>
    <message>
        <source>exception 2: it has no such register; is it a touchpad with this register map?</source>
        <translation>exception 2 : il n'a pas ce registre ; est-ce un touchpad avec cette table de registres ?</translation>
    </message>
    <message>
        <source>exception 3: it refuses the value</source>
        <translation>exception 3 : il refuse la valeur</translation>
    </message>
    <message>
        <source>exception 4: it failed; see the touchpad's own display or log</source>
        <translation>exception 4 : il a échoué ; voir l'affichage ou le journal du touchpad</translation>
    </message>
    <message>
        <source>exception 5: it needs longer</source>
        <translation>exception 5 : il lui faut plus de temps</translation>
    </message>
    <message>
        <source>exception 6: it is busy, another program drives its motors; close that one</source>
        <translation>exception 6 : il est occupé, un autre programme commande ses moteurs ; le fermer</translation>
    </message>
    <message>
        <source>exception 7: it cannot do this</source>
        <translation>exception 7 : il ne peut pas faire cela</translation>
    </message>
    <message>
        <source>exception 8: memory parity error</source>
        <translation>exception 8 : erreur de parité de la mémoire</translation>
    </message>
    <message>
        <source>excitation at {} s: angle {}°; expected numbers</source>
        <translation>excitation à {} s : angle {}° ; attendu des nombres</translation>
    </message>
    <message>
        <source>excitation: stiffness observable in {} samples over {:.2f} s; expected at least {} over {} s</source>
        <translation>excitation : raideur observable en {} échantillons sur {:.2f} s ; attendu au moins {} sur {} s</translation>
    </message>
    <message>
        <source>excitation: stretch {:.1f}…{:.1f}° moves the law by {:.1f} %; expected at least {:.0f} %</source>
        <translation>excitation : l'étirement {:.1f}…{:.1f}° fait varier la loi de {:.1f} % ; attendu au moins {:.0f} %</translation>
    </message>
    <message>
        <source>excitation: the model explains {:.0f} % of the measured stiffness' changes; expected at least {:.0f} %</source>
        <translation>excitation : le modèle explique {:.0f} % des variations de la raideur mesurée ; attendu au moins {:.0f} %</translation>
    </message>
    <message>
        <source>excitation: {} s after {} s; expected time to rise</source>
        <translation>excitation : {} s après {} s ; le temps doit croître</translation>
    </message>
    <message>
        <source>expected [[record]]</source>
        <translation>attendu [[record]]</translation>
    </message>
    <message>
        <source>expected a camera that Video4Linux can read, and the right to open it</source>
        <translation>attendu une caméra que Video4Linux sait lire, et le droit de l'ouvrir</translation>
    </message>
    <message>
        <source>expected a stream that FFmpeg can play and that starts within 3 s</source>
        <translation>attendu un flux que FFmpeg sait lire et qui commence en 3 s</translation>
    </message>
    <message>
        <source>expected a video that FFmpeg can decode</source>
        <translation>attendu une vidéo que FFmpeg sait décoder</translation>
    </message>
    <message>
        <source>exposure</source>
        <translation>exposition</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>défaut</translation>
    </message>
    <message>
        <source>fault '{}': expected NAME@SECONDS or NAME@SECONDS+DURATION with one of {}</source>
        <translation>défaut '{}' : attendu NAME@SECONDS ou NAME@SECONDS+DURATION avec l'un de {}</translation>
    </message>
    <message>
        <source>fault reaction active</source>
        <translation>réaction au défaut en cours</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>senti</translation>
    </message>
    <message>
        <source>field</source>
        <translation>champ</translation>
    </message>
    <message>
        <source>field "{}": asked for twice</source>
        <translation>champ « {} » : demandé deux fois</translation>
    </message>
    <message>
        <source>field "{}": there is none of this name; there are {}</source>
        <translation>champ « {} » : il n'y en a pas de ce nom ; il y a {}</translation>
    </message>
    <message>
        <source>field {} of {}</source>
        <translation>champ {} sur {}</translation>
    </message>
    <message>
        <source>figures from {} s to {} s: expected two times</source>
        <translation>valeurs de {} s à {} s : attendu deux temps</translation>
    </message>
    <message>
        <source>file missing</source>
        <translation>fichier manquant</translation>
    </message>
    <message>
        <source>filter: {}</source>
        <translation>filtre : {}</translation>
    </message>
    <message>
        <source>fine: calibrated %1 days ago</source>
        <translation>bon : étalonné il y a %1 jours</translation>
    </message>
    <message>
        <source>fine: calibrated today</source>
        <translation>bon : étalonné aujourd'hui</translation>
    </message>
    <message>
        <source>fine: calibrated yesterday</source>
        <translation>bon : étalonné hier</translation>
    </message>
    <message>
        <source>finger</source>
        <translation>doigt</translation>
    </message>
    <message>
        <source>finger '{}': only the simulated touchpad has a simulated finger</source>
        <translation>doigt '{}' : seul le touchpad simulé a un doigt simulé</translation>
    </message>
    <message>
        <source>finger ({:.0f}) and cloth ({:.0f}) are not told apart: put a finger on the cloth, or more light behind it</source>
        <translation>doigt ({:.0f}) et tissu ({:.0f}) ne se distinguent pas : poser un doigt sur le tissu, ou plus de lumière derrière</translation>
    </message>
    <message>
        <source>finger at {:.0f}, cloth at {:.0f}, threshold {}</source>
        <translation>doigt à {:.0f}, tissu à {:.0f}, seuil {}</translation>
    </message>
    <message>
        <source>finger_mm of a soft body is {}; expected more than 0</source>
        <translation>finger_mm d'un corps mou est {} ; attendu plus de 0</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>terminé</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>micrologiciel</translation>
    </message>
    <message>
        <source>first</source>
        <translation>premier</translation>
    </message>
    <message>
        <source>first scale</source>
        <translation>échelle du premier</translation>
    </message>
    <message>
        <source>first zero</source>
        <translation>zéro du premier</translation>
    </message>
    <message>
        <source>flat picture</source>
        <translation>image plate</translation>
    </message>
    <message>
        <source>flow {} bit/s: expected more than 0</source>
        <translation>débit {} bit/s : attendu plus de 0</translation>
    </message>
    <message>
        <source>folder</source>
        <translation>dossier</translation>
    </message>
    <message>
        <source>folder {}, {} pictures at {:.0f} fps, repeating</source>
        <translation>dossier {}, {} images à {:.0f} i/s, en boucle</translation>
    </message>
    <message>
        <source>folder: {}</source>
        <translation>dossier : {}</translation>
    </message>
    <message>
        <source>for %1</source>
        <translation>depuis %1</translation>
    </message>
    <message>
        <source>force</source>
        <translation>force</translation>
    </message>
    <message>
        <source>force = {} N: expected {} … {}</source>
        <translation>force = {} N : attendu {} … {}</translation>
    </message>
    <message>
        <source>force too small</source>
        <translation>force trop petite</translation>
    </message>
    <message>
        <source>force unavailable</source>
        <translation>force indisponible</translation>
    </message>
    <message>
        <source>found</source>
        <translation>trouvé</translation>
    </message>
    <message>
        <source>frame = {}: expected 2 … {} samples</source>
        <translation>frame = {} : attendu 2 … {} échantillons</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>from robot</source>
        <translation>du robot</translation>
    </message>
    <message>
        <source>from the future</source>
        <translation>venu du futur</translation>
    </message>
    <message>
        <source>from the start</source>
        <translation>depuis le début</translation>
    </message>
    <message>
        <source>from {} s to {} s: the first must not be larger than the second</source>
        <translation>de {} s à {} s : le premier ne doit pas dépasser le second</translation>
    </message>
    <message>
        <source>front and back edges are free</source>
        <translation>les bords avant et arrière sont libres</translation>
    </message>
    <message>
        <source>gain margin %1, phase margin %2</source>
        <translation>marge de gain %1, marge de phase %2</translation>
    </message>
    <message>
        <source>gains of the chirps from {:.2f} to {:.2f}; expected them within a factor of {}</source>
        <translation>gains des balayages de {:.2f} à {:.2f} ; attendus dans un facteur de {}</translation>
    </message>
    <message>
        <source>gesture "{}": {} rows from {} to {} s: expected two and more of its {} s</source>
        <translation>geste "{}" : {} lignes de {} à {} s : deux ou plus attendues de ses {} s</translation>
    </message>
    <message>
        <source>gesture: {} rows: expected two and more</source>
        <translation>geste : {} lignes : deux ou plus attendues</translation>
    </message>
    <message>
        <source>go to, s</source>
        <translation>aller à, s</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>disparu</translation>
    </message>
    <message>
        <source>good</source>
        <translation>bonne</translation>
    </message>
    <message>
        <source>handshake</source>
        <translation>poignée de main</translation>
    </message>
    <message>
        <source>has said goodbye</source>
        <translation>a pris congé</translation>
    </message>
    <message>
        <source>has switched its motors off by itself</source>
        <translation>a coupé ses moteurs d'elle-même</translation>
    </message>
    <message>
        <source>heartbeat lost</source>
        <translation>battement perdu</translation>
    </message>
    <message>
        <source>height</source>
        <translation>hauteur</translation>
    </message>
    <message>
        <source>held and free edges fit nearly alike (error {:.2f} and {:.2f} mm): the edges are not proven</source>
        <translation>bords tenus et bords libres conviennent presque autant (erreur {:.2f} et {:.2f} mm) : les bords ne sont pas prouvés</translation>
    </message>
    <message>
        <source>held-out error {} of at most {:g} N over {} weights</source>
        <translation>erreur de vérification {} (au plus {:g} N) sur {} poids</translation>
    </message>
    <message>
        <source>held-out error {} of at most {:g} N; stiffness rises from {:.3f} to {:.3f} N/mm</source>
        <translation>erreur de vérification {} (au plus {:g} N) ; la raideur croît de {:.3f} à {:.3f} N/mm</translation>
    </message>
    <message>
        <source>held-out error {} of at most {:g} deg</source>
        <translation>erreur de vérification {} (au plus {:g}°)</translation>
    </message>
    <message>
        <source>held-out error {} of at most {:g} mm</source>
        <translation>erreur de vérification {} (au plus {:g} mm)</translation>
    </message>
    <message>
        <source>held-out error {} of at most {:g} mm; radius share {:.3f} ± {:.3f}, tension ratio {:.2f} ± {:.2f}; all edges are held</source>
        <translation>erreur de vérification {}, au plus {:g} mm ; part du rayon {:.3f} ± {:.3f}, rapport de tension {:.2f} ± {:.2f} ; tous les bords sont tenus</translation>
    </message>
    <message>
        <source>held-out error {} of at most {:g} mm; radius share {:.3f} ± {:.3f}, tension ratio {:.2f} ± {:.2f}; front and back edges are free: this cloth cannot be known better from such presses (about 0.7 mm and 20 % of stiffness)</source>
        <translation>erreur de vérification {}, au plus {:g} mm ; part du rayon {:.3f} ± {:.3f}, rapport de tension {:.2f} ± {:.2f} ; les bords avant et arrière sont libres : de tels appuis ne peuvent faire mieux connaître ce tissu (environ 0,7 mm et 20 % de raideur)</translation>
    </message>
    <message>
        <source>held-out error {}; expected at most {:g} N: {}</source>
        <translation>erreur de vérification {} ; attendu au plus {:g} N : {}</translation>
    </message>
    <message>
        <source>held-out error {}; expected at most {:g} mm: tare, and press straight down over the middle of each sensor</source>
        <translation>erreur de vérification {} ; attendu au plus {:g} mm : faites la tare et appuyez bien droit au-dessus du milieu de chaque capteur</translation>
    </message>
    <message>
        <source>held-out error {}; expected at most {:g} mm: {}</source>
        <translation>erreur de vérification {} ; attendu au plus {:g} mm : {}</translation>
    </message>
    <message>
        <source>held-out error {}; expected at most {:g}: sweep slower, and wait at each angle</source>
        <translation>erreur de vérification {} ; attendu au plus {:g} : balayer plus lentement, et attendre à chaque angle</translation>
    </message>
    <message>
        <source>histogram</source>
        <translation>histogramme</translation>
    </message>
    <message>
        <source>hop = {}: expected a divisor of the frame, {} (blocks) or less (overlapped)</source>
        <translation>hop = {} : attendu un diviseur de la trame, {} (blocs) ou moins (avec recouvrement)</translation>
    </message>
    <message>
        <source>hysteresis %1</source>
        <translation>hystérésis %1</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>en attente</translation>
    </message>
    <message>
        <source>images off</source>
        <translation>images non</translation>
    </message>
    <message>
        <source>images on</source>
        <translation>images oui</translation>
    </message>
    <message>
        <source>indentation too small</source>
        <translation>indentation trop petite</translation>
    </message>
    <message>
        <source>indentation unavailable</source>
        <translation>indentation indisponible</translation>
    </message>
    <message>
        <source>inverse, a/(v + b) + c</source>
        <translation>inverse, a/(v + b) + c</translation>
    </message>
    <message>
        <source>is %1</source>
        <translation>est %1</translation>
    </message>
    <message>
        <source>its first bytes cannot be read</source>
        <translation>ses premiers octets ne peuvent pas être lus</translation>
    </message>
    <message>
        <source>its header is damaged: the checksum differs</source>
        <translation>son en-tête est endommagé : la somme de contrôle diffère</translation>
    </message>
    <message>
        <source>its lock cannot be had, it may be recorded at this moment: {}</source>
        <translation>son verrou ne peut pas être obtenu, il est peut-être en cours d'enregistrement : {}</translation>
    </message>
    <message>
        <source>its recorder is gone; make it whole with: fyd session recover</source>
        <translation>son enregistreur n'est plus là ; le rendre entier par : fyd session recover</translation>
    </message>
    <message>
        <source>jerk limit {} mm/s³: expected 1000 to 10000000</source>
        <translation>limite d'à-coup {} mm/s³ : attendu de 1000 à 10000000</translation>
    </message>
    <message>
        <source>jitter {} ms: expected 0 … {}</source>
        <translation>gigue {} ms : 0 … {} attendu</translation>
    </message>
    <message>
        <source>joint impedance</source>
        <translation>impédance articulaire</translation>
    </message>
    <message>
        <source>key</source>
        <translation>clé</translation>
    </message>
    <message>
        <source>key file {}: exists already; a key is never overwritten</source>
        <translation>fichier de clé {} : existe déjà ; une clé n'est jamais écrasée</translation>
    </message>
    <message>
        <source>key file {}: longer than {} bytes; not a key</source>
        <translation>fichier de clé {} : plus long que {} octets ; pas une clé</translation>
    </message>
    <message>
        <source>key file {}: not a regular file</source>
        <translation>fichier de clé {} : pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>key file {}: open to others (mode {:04o}); make it private with: chmod 600 {}</source>
        <translation>fichier de clé {} : ouvert aux autres (mode {:04o}) ; le rendre privé par : chmod 600 {}</translation>
    </message>
    <message>
        <source>key file {}: {}</source>
        <translation>fichier de clé {} : {}</translation>
    </message>
    <message>
        <source>kind "{}"; expected note or bookmark</source>
        <translation>sorte « {} » ; attendu note ou bookmark</translation>
    </message>
    <message>
        <source>largest %1 at %2</source>
        <translation>maximum %1 à %2</translation>
    </message>
    <message>
        <source>largest residual %1</source>
        <translation>plus grand résidu %1</translation>
    </message>
    <message>
        <source>last touch</source>
        <translation>dernier toucher</translation>
    </message>
    <message>
        <source>late</source>
        <translation>en retard</translation>
    </message>
    <message>
        <source>lay the target flat and set the camera square to it</source>
        <translation>poser la cible à plat et mettre la caméra d'équerre</translation>
    </message>
    <message>
        <source>lead of {} ms: expected 0 to 500</source>
        <translation>avance de {} ms : attendu 0 à 500</translation>
    </message>
    <message>
        <source>left and right</source>
        <translation>à gauche et à droite</translation>
    </message>
    <message>
        <source>left as it is</source>
        <translation>laissé tel quel</translation>
    </message>
    <message>
        <source>less</source>
        <translation>de moins</translation>
    </message>
    <message>
        <source>let the motors and the cloth come to rest, and start again</source>
        <translation>laisser moteurs et tissu au repos, et recommencer</translation>
    </message>
    <message>
        <source>lies on the other's</source>
        <translation>repose sur celui de l'autre</translation>
    </message>
    <message>
        <source>light unknown</source>
        <translation>lumière inconnue</translation>
    </message>
    <message>
        <source>light, temperature, target</source>
        <translation>lumière, température, cible</translation>
    </message>
    <message>
        <source>limit reached before two samples</source>
        <translation>limite atteinte avant deux échantillons</translation>
    </message>
    <message>
        <source>line</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>live</source>
        <translation>en direct</translation>
    </message>
    <message>
        <source>live, peak</source>
        <translation>direct, crête</translation>
    </message>
    <message>
        <source>load cell</source>
        <translation>cellule de charge</translation>
    </message>
    <message>
        <source>load cell: {:.3f} mV/V lies beyond the bridge's span</source>
        <translation>cellule de charge : {:.3f} mV/V dépasse la plage du pont</translation>
    </message>
    <message>
        <source>loading reads {:.3f} N apart from unloading: look for friction between the cell and its plate</source>
        <translation>l'aller et le retour diffèrent de {:.3f} N : chercher un frottement entre la cellule et son plateau</translation>
    </message>
    <message>
        <source>longest_step_s of a soft body is {}; expected more than 0</source>
        <translation>longest_step_s d'un corps mou est {} ; attendu plus de 0</translation>
    </message>
    <message>
        <source>look at the distance sensors' curves and at the load cell's cable</source>
        <translation>regarder les courbes des capteurs de distance et le câble de la cellule de charge</translation>
    </message>
    <message>
        <source>loss {} %: expected 0 … 100</source>
        <translation>perte {} % : 0 … 100 attendu</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>perdu</translation>
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
        <translation>mass_kg d'un corps mou est {} ; attendu 0 ou plus</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>moyenne</translation>
    </message>
    <message>
        <source>mean x</source>
        <translation>moyenne x</translation>
    </message>
    <message>
        <source>mean y</source>
        <translation>moyenne y</translation>
    </message>
    <message>
        <source>mean z</source>
        <translation>moyenne z</translation>
    </message>
    <message>
        <source>measure the outliers again</source>
        <translation>mesurer à nouveau les valeurs aberrantes</translation>
    </message>
    <message>
        <source>measure the outliers again, or leave them out</source>
        <translation>mesurer à nouveau les valeurs aberrantes, ou les exclure</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>mesuré</translation>
    </message>
    <message>
        <source>measured joint</source>
        <translation>articulation mesurée</translation>
    </message>
    <message>
        <source>measured with another calibration: measure it again</source>
        <translation>mesurée avec un autre étalonnage : la mesurer de nouveau</translation>
    </message>
    <message>
        <source>measured without the invalid sensors</source>
        <translation>mesuré sans les capteurs invalides</translation>
    </message>
    <message>
        <source>membrane: radius share and tension ratio</source>
        <translation>membrane : part du rayon et rapport de tension</translation>
    </message>
    <message>
        <source>message</source>
        <translation>message</translation>
    </message>
    <message>
        <source>method number {}: unknown</source>
        <translation>méthode numéro {} : inconnue</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>monitor</source>
        <translation>moniteur</translation>
    </message>
    <message>
        <source>more</source>
        <translation>de plus</translation>
    </message>
    <message>
        <source>more than 5 % of the haptic cycles of one second were missed</source>
        <translation>plus de 5 % des cycles haptiques d'une seconde ont été manqués</translation>
    </message>
    <message>
        <source>most_parts of a soft body is {}; expected 1 or more</source>
        <translation>most_parts d'un corps mou est {} ; attendu 1 ou plus</translation>
    </message>
    <message>
        <source>most_points of a soft body is {}; expected 3 or more</source>
        <translation>most_points d'un corps mou est {} ; attendu 3 ou plus</translation>
    </message>
    <message>
        <source>motor 1</source>
        <translation>moteur 1</translation>
    </message>
    <message>
        <source>motor 2</source>
        <translation>moteur 2</translation>
    </message>
    <message>
        <source>motor board {} at {} does not obey: its motors are on, expected off; switch off its supply</source>
        <translation>la carte moteurs {} sur {} n'obéit pas : ses moteurs sont en marche, attendus coupés ; couper son alimentation</translation>
    </message>
    <message>
        <source>motor board {} at {} {}: mend that, then arm again</source>
        <translation>carte moteurs {} sur {} {} : y remédier, puis armer de nouveau</translation>
    </message>
    <message>
        <source>motor board {} at {}, {} Bd</source>
        <translation>carte moteurs {} sur {}, {} Bd</translation>
    </message>
    <message>
        <source>motor board {} at {}, {} Bd, no vibration (device.qbmove_vibration_opcode is not set)</source>
        <translation>carte moteurs {} sur {}, {} Bd, sans vibration (device.qbmove_vibration_opcode n'est pas réglé)</translation>
    </message>
    <message>
        <source>motor board {} at {}: current {} is {} mA, expected -{} to {}</source>
        <translation>carte moteurs {} sur {} : le courant {} est de {} mA, attendu de -{} à {}</translation>
    </message>
    <message>
        <source>motor board {} at {}: no answer to command {} in {} ms; is it on, and are device.qbmove_baud = {} and device.qbmove_id right?</source>
        <translation>carte moteurs {} sur {} : pas de réponse à la commande {} en {} ms ; est-elle allumée, et device.qbmove_baud = {} et device.qbmove_id sont-ils justes ?</translation>
    </message>
    <message>
        <source>motor board: nothing received yet</source>
        <translation>carte moteurs : encore rien reçu</translation>
    </message>
    <message>
        <source>motor currents {} mA, expected -{} to {}</source>
        <translation>courants des moteurs {} mA, attendus de -{} à {}</translation>
    </message>
    <message>
        <source>motor over-temperature</source>
        <translation>surchauffe d'un moteur</translation>
    </message>
    <message>
        <source>motor reference off</source>
        <translation>référence moteurs non</translation>
    </message>
    <message>
        <source>motor reference on</source>
        <translation>référence moteurs oui</translation>
    </message>
    <message>
        <source>motor temperatures {} °C, expected {} to {}</source>
        <translation>températures des moteurs {} °C, attendues de {} à {}</translation>
    </message>
    <message>
        <source>motor {} stands at {:.1f}°, beyond control.motor_limit_deg = {:.0f}: check the encoder's zero</source>
        <translation>le moteur {} est à {:.1f}°, au-delà de control.motor_limit_deg = {:.0f} : vérifier le zéro du codeur</translation>
    </message>
    <message>
        <source>motors</source>
        <translation>moteurs</translation>
    </message>
    <message>
        <source>motors %1</source>
        <translation>moteurs %1</translation>
    </message>
    <message>
        <source>motors '{}': a recording drives no motors</source>
        <translation>moteurs '{}' : un enregistrement ne commande pas de moteurs</translation>
    </message>
    <message>
        <source>motors '{}': expected qbmove:TTY</source>
        <translation>moteurs '{}' : attendu qbmove:TTY</translation>
    </message>
    <message>
        <source>motors and cloth identified</source>
        <translation>moteurs et tissu identifiés</translation>
    </message>
    <message>
        <source>motors at {:.0f} and {:.0f} °C, switched off at {:.0f}: let them cool</source>
        <translation>moteurs à {:.0f} et {:.0f} °C, coupés à {:.0f} : les laisser refroidir</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>en mouvement</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>network profile "{}": expected isdn, adsl, lan or a CSV file</source>
        <translation>profil de réseau « {} » : attendu isdn, adsl, lan ou un fichier CSV</translation>
    </message>
    <message>
        <source>network {} {} {}: expected 0 to {}</source>
        <translation>réseau {} {} {} : attendu de 0 à {}</translation>
    </message>
    <message>
        <source>never calibrated</source>
        <translation>jamais étalonné</translation>
    </message>
    <message>
        <source>no JPEG decoder: {}</source>
        <translation>pas de décodeur JPEG : {}</translation>
    </message>
    <message>
        <source>no answer in {:.0f} ms; is it switched on and connected?</source>
        <translation>pas de réponse en {:.0f} ms ; est-il allumé et connecté ?</translation>
    </message>
    <message>
        <source>no answer yet</source>
        <translation>pas encore de réponse</translation>
    </message>
    <message>
        <source>no catalogue was chosen</source>
        <translation>aucun catalogue n'a été choisi</translation>
    </message>
    <message>
        <source>no commit in it can be trusted: all {} are damaged</source>
        <translation>aucune validation n'y est fiable : toutes les {} sont endommagées</translation>
    </message>
    <message>
        <source>no commit in it can be trusted: nothing was ever completely written</source>
        <translation>aucune validation n'y est fiable : rien n'a jamais été écrit en entier</translation>
    </message>
    <message>
        <source>no contact within the travel limit</source>
        <translation>pas de contact dans la limite de course</translation>
    </message>
    <message>
        <source>no curve can be used ({}): add points, spread over 40 to 300 mm</source>
        <translation>aucune courbe n'est utilisable ({}) : ajouter des points, répartis de 40 à 300 mm</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>pas de données</translation>
    </message>
    <message>
        <source>no device tells '{}': look under Devices whether the touchpad answers</source>
        <translation>aucun appareil ne donne '{}' : voir dans Appareils si le touchpad répond</translation>
    </message>
    <message>
        <source>no finger</source>
        <translation>pas de doigt</translation>
    </message>
    <message>
        <source>no force is measured: look at the load cell's cable</source>
        <translation>aucune force mesurée : regarder le câble de la cellule de charge</translation>
    </message>
    <message>
        <source>no indentation is measured: press the cloth with a finger</source>
        <translation>aucune indentation mesurée : presser le tissu du doigt</translation>
    </message>
    <message>
        <source>no picture</source>
        <translation>pas d'image</translation>
    </message>
    <message>
        <source>no picture from {} s to {} s</source>
        <translation>pas d'image de {} s à {} s</translation>
    </message>
    <message>
        <source>no picture was taken up to {} s</source>
        <translation>aucune image n'a été prise jusqu'à {} s</translation>
    </message>
    <message>
        <source>no place yet: click a mark of the target in the picture</source>
        <translation>pas encore de position : cliquer une marque de la cible dans l'image</translation>
    </message>
    <message>
        <source>no point between {:g} and {:g} mm, {:.0f} % of the span: add points between {:g} and {:g} mm</source>
        <translation>aucun point entre {:g} et {:g} mm, {:.0f} % de la plage : ajouter des points entre {:g} et {:g} mm</translation>
    </message>
    <message>
        <source>no points: add points between 40 and 300 mm</source>
        <translation>aucun point : ajouter des points entre 40 et 300 mm</translation>
    </message>
    <message>
        <source>no press at {:.3g} deg is deeper than {:.3g} mm; expected at least {:g} mm: press deeper there</source>
        <translation>aucune pression à {:.3g}° ne dépasse {:.3g} mm ; il faut au moins {:g} mm : y presser plus</translation>
    </message>
    <message>
        <source>no press is within {:g} mm of a distance sensor that reads: press over each sensor</source>
        <translation>aucun appui n'est à moins de {:g} mm d'un capteur de distance qui lit : appuyez au-dessus de chaque capteur</translation>
    </message>
    <message>
        <source>no press over distance sensor {}: press over each sensor, at two depths</source>
        <translation>aucun appui au-dessus du capteur de distance {} : appuyez au-dessus de chaque capteur, à deux profondeurs</translation>
    </message>
    <message>
        <source>no problem</source>
        <translation>pas de problème</translation>
    </message>
    <message>
        <source>no program that this user can see</source>
        <translation>aucun programme que cet utilisateur puisse voir</translation>
    </message>
    <message>
        <source>no ramp of motor {} with {} duty; expected each motor both ways</source>
        <translation>pas de rampe du moteur {} à rapport cyclique {} ; chaque moteur est attendu dans les deux sens</translation>
    </message>
    <message>
        <source>no recent picture</source>
        <translation>pas d'image récente</translation>
    </message>
    <message>
        <source>no region of interest from {} s to {} s</source>
        <translation>pas de région d'intérêt de {} s à {} s</translation>
    </message>
    <message>
        <source>no region yet: drag a rectangle around the cloth in the picture</source>
        <translation>pas encore de région : tracer un rectangle autour du tissu dans l'image</translation>
    </message>
    <message>
        <source>no robot has connected</source>
        <translation>aucun robot ne s'est connecté</translation>
    </message>
    <message>
        <source>no samples from {} s to {} s: the recording has {}, to {:.3f} s</source>
        <translation>pas d'échantillons de {} s à {} s : l'enregistrement en a {}, jusqu'à {:.3f} s</translation>
    </message>
    <message>
        <source>no scene is shared</source>
        <translation>aucune scène n'est partagée</translation>
    </message>
    <message>
        <source>no stiffness target</source>
        <translation>pas de raideur de consigne</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>ce fichier n'existe pas</translation>
    </message>
    <message>
        <source>no threshold is suggested, the present one stays: {}</source>
        <translation>aucun seuil n'est proposé, le présent reste : {}</translation>
    </message>
    <message>
        <source>no touchpad answered</source>
        <translation>aucun touchpad n'a répondu</translation>
    </message>
    <message>
        <source>no touchpad with this key answered</source>
        <translation>aucun touchpad avec cette clé n'a répondu</translation>
    </message>
    <message>
        <source>no value changes: the texture takes rest away by itself</source>
        <translation>aucune valeur ne change : la texture retire elle-même le repos</translation>
    </message>
    <message>
        <source>no video can be written: OpenCV has no coder for it, or the disk is full</source>
        <translation>aucune vidéo ne peut être écrite : OpenCV n'a pas de codeur pour elle, ou le disque est plein</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>none since the start</source>
        <translation>aucune depuis le démarrage</translation>
    </message>
    <message>
        <source>not FYD Link</source>
        <translation>pas du FYD Link</translation>
    </message>
    <message>
        <source>not a digit</source>
        <translation>pas un chiffre</translation>
    </message>
    <message>
        <source>not a file</source>
        <translation>ce n'est pas un fichier</translation>
    </message>
    <message>
        <source>not a recording, or too damaged to open</source>
        <translation>pas un enregistrement, ou trop endommagé pour être ouvert</translation>
    </message>
    <message>
        <source>not confirmed: the station did not answer. It last used %1.</source>
        <translation>non confirmé : la station n'a pas répondu. Elle utilisait en dernier %1.</translation>
    </message>
    <message>
        <source>not enough experiments yet</source>
        <translation>pas encore assez d'expériences</translation>
    </message>
    <message>
        <source>not identified</source>
        <translation>non identifiés</translation>
    </message>
    <message>
        <source>not opened through the console's driver</source>
        <translation>pas ouvert par le pilote de la console</translation>
    </message>
    <message>
        <source>not ready to switch on</source>
        <translation>pas prêt à s'allumer</translation>
    </message>
    <message>
        <source>not told by this robot</source>
        <translation>non dit par ce robot</translation>
    </message>
    <message>
        <source>note</source>
        <translation>note</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>nothing is being recorded</source>
        <translation>rien n'est enregistré</translation>
    </message>
    <message>
        <source>nothing listens there; is the touchpad on and the port right?</source>
        <translation>rien n'y écoute ; le touchpad est-il allumé et le port juste ?</translation>
    </message>
    <message>
        <source>nothing missing</source>
        <translation>rien ne manque</translation>
    </message>
    <message>
        <source>nothing received yet</source>
        <translation>encore rien reçu</translation>
    </message>
    <message>
        <source>now</source>
        <translation>maintenant</translation>
    </message>
    <message>
        <source>number not finite</source>
        <translation>nombre non fini</translation>
    </message>
    <message>
        <source>number out of range</source>
        <translation>nombre hors limites</translation>
    </message>
    <message>
        <source>observed</source>
        <translation>observée</translation>
    </message>
    <message>
        <source>off</source>
        <translation>éteint</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>décalage</translation>
    </message>
    <message>
        <source>offset of the commanded</source>
        <translation>décalage du commandé</translation>
    </message>
    <message>
        <source>old: %1</source>
        <translation>vieux : %1</translation>
    </message>
    <message>
        <source>on</source>
        <translation>allumé</translation>
    </message>
    <message>
        <source>once</source>
        <translation>une fois</translation>
    </message>
    <message>
        <source>one of {}</source>
        <translation>un parmi {}</translation>
    </message>
    <message>
        <source>only {} of {} frames could be written; is the disk full?</source>
        <translation>seules {} images sur {} ont pu être écrites ; le disque est-il plein ?</translation>
    </message>
    <message>
        <source>operation enabled</source>
        <translation>en marche</translation>
    </message>
    <message>
        <source>other</source>
        <translation>autre</translation>
    </message>
    <message>
        <source>other address</source>
        <translation>autre adresse</translation>
    </message>
    <message>
        <source>other session</source>
        <translation>autre session</translation>
    </message>
    <message>
        <source>other version</source>
        <translation>autre version</translation>
    </message>
    <message>
        <source>out of reach</source>
        <translation>hors de portée</translation>
    </message>
    <message>
        <source>out of reach: less than is felt arrives</source>
        <translation>hors de portée : il arrive moins que ce qui se sent</translation>
    </message>
    <message>
        <source>out of turn</source>
        <translation>hors de son tour</translation>
    </message>
    <message>
        <source>outside {:.0f} to {:.0f} mm the sensor will count as invalid: the cloth rests at about 100 mm</source>
        <translation>hors de {:.0f} à {:.0f} mm le capteur comptera comme non valable : le tissu au repos est à environ 100 mm</translation>
    </message>
    <message>
        <source>pairing code</source>
        <translation>code d'appairage</translation>
    </message>
    <message>
        <source>pairing code: the checksum does not fit; a word is another than it was, or the order is</source>
        <translation>code d'appairage : la somme de contrôle ne correspond pas ; un mot n'est pas celui d'origine, ou l'ordre</translation>
    </message>
    <message>
        <source>pairing code: word {} is not a pairing word; check its spelling</source>
        <translation>code d'appairage : le mot {} n'est pas un mot d'appairage ; vérifier son orthographe</translation>
    </message>
    <message>
        <source>pairing code: {} words; expected {}</source>
        <translation>code d'appairage : {} mots ; attendu {}</translation>
    </message>
    <message>
        <source>part {}: a chirp of {} s; expected {} s and more</source>
        <translation>partie {} : un balayage de {} s ; attendu {} s et plus</translation>
    </message>
    <message>
        <source>part {}: duty of motor {} goes from {} to {} %: expected a ramp in steps of at most {} %</source>
        <translation>partie {} : le rapport cyclique du moteur {} passe de {} à {} % : attendu une rampe par pas de {} % au plus</translation>
    </message>
    <message>
        <source>part {}: motor {} did not turn up to a duty of {} %; expected a ramp until it turns</source>
        <translation>partie {} : le moteur {} n'a pas tourné jusqu'à un rapport cyclique de {} % ; attendu une rampe jusqu'à ce qu'il tourne</translation>
    </message>
    <message>
        <source>part {}: motor {} moves before it has a duty</source>
        <translation>partie {} : le moteur {} bouge avant d'avoir un rapport cyclique</translation>
    </message>
    <message>
        <source>part {}: neither a ramp of one motor nor a chirp of both with the same duty</source>
        <translation>partie {} : ni une rampe d'un moteur ni un balayage des deux avec le même rapport cyclique</translation>
    </message>
    <message>
        <source>part {}: no acceleration_g at {} s; the chirp needs an accelerometer on the cloth: encoders, load cell and currents cannot see it</source>
        <translation>partie {} : pas d'acceleration_g à {} s ; le balayage demande un accéléromètre sur le tissu : codeurs, cellule de charge et courants ne peuvent pas le voir</translation>
    </message>
    <message>
        <source>part {}: resonance {:.1f} ± {:.1f} Hz: not determined; expected ± {:.0f} % or better</source>
        <translation>partie {} : résonance {:.1f} ± {:.1f} Hz : non déterminée ; attendu ± {:.0f} % ou mieux</translation>
    </message>
    <message>
        <source>part {}: the model leaves {:.0f} % of the acceleration held out; expected at most {:.0f} %</source>
        <translation>partie {} : le modèle laisse {:.0f} % de l'accélération mise de côté ; attendu au plus {:.0f} %</translation>
    </message>
    <message>
        <source>parts missing</source>
        <translation>parties manquantes</translation>
    </message>
    <message>
        <source>path '{}': expected an absolute one</source>
        <translation>chemin '{}' : attendu un chemin absolu</translation>
    </message>
    <message>
        <source>path: {}</source>
        <translation>chemin : {}</translation>
    </message>
    <message>
        <source>patience of {} ms: expected 1 to 10000</source>
        <translation>patience de {} ms : attendu 1 à 10000</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>en pause</translation>
    </message>
    <message>
        <source>perceptron: number {} is "{}"; expected one from {} to {}</source>
        <translation>perceptron : le nombre {} est "{}" ; attendu un de {} à {}</translation>
    </message>
    <message>
        <source>perceptron: {} inputs, {} hidden units, {} outputs and {} weights; expected {}, {}, {} and {}</source>
        <translation>perceptron : {} entrées, {} unités cachées, {} sorties et {} poids ; {}, {}, {} et {} attendus</translation>
    </message>
    <message>
        <source>perfect</source>
        <translation>parfaite</translation>
    </message>
    <message>
        <source>period {} ms: expected 0 (each row) or 0.1 … {}</source>
        <translation>période {} ms : 0 (chaque ligne) ou 0.1 … {} attendu</translation>
    </message>
    <message>
        <source>period {} ms: expected 1 … 10000</source>
        <translation>période de {} ms : attendu 1 … 10000</translation>
    </message>
    <message>
        <source>period {} ms: expected more than 0</source>
        <translation>période {} ms : attendu plus de 0</translation>
    </message>
    <message>
        <source>period {} ms: {:.0f} messages in {} s; expected at most {}: take a longer period or less of the trace</source>
        <translation>période {} ms : {:.0f} messages en {} s ; attendu : {} au plus ; prendre une période plus longue ou moins de la trace</translation>
    </message>
    <message>
        <source>picture and target are mirror images; if the camera shows no mirrored picture, the signs of y_mm are wrong: it grows to the back, upward in the picture</source>
        <translation>image et cible sont en miroir ; si la caméra ne montre pas une image inversée, les signes de y_mm sont faux : il croît vers l'arrière, vers le haut dans l'image</translation>
    </message>
    <message>
        <source>picture {} cannot be coded</source>
        <translation>l'image {} ne peut pas être codée</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>images</translation>
    </message>
    <message>
        <source>pilot, left hand</source>
        <translation>pilote, main gauche</translation>
    </message>
    <message>
        <source>ply header, line {} "{}": expected format 1.0, then elements vertex (x, y, z, each float or double) and face (a list vertex_indices, uchar int) with the types of their properties</source>
        <translation>en-tête ply, ligne {} "{}" : attendu format 1.0, puis les éléments vertex (x, y, z, chacun float ou double) et face (une list vertex_indices, uchar int) avec les types de leurs propriétés</translation>
    </message>
    <message>
        <source>png: the picture could not be made</source>
        <translation>png : l'image n'a pas pu être faite</translation>
    </message>
    <message>
        <source>polynomial of degree 2</source>
        <translation>polynôme de degré 2</translation>
    </message>
    <message>
        <source>polynomial of degree 3</source>
        <translation>polynôme de degré 3</translation>
    </message>
    <message>
        <source>polynomial of degree 4</source>
        <translation>polynôme de degré 4</translation>
    </message>
    <message>
        <source>polynomial of degree 5</source>
        <translation>polynôme de degré 5</translation>
    </message>
    <message>
        <source>polynomial: c0 + c1 v + ..., constant first; inverse: c0/(v + c1) + c2.</source>
        <translation>polynomial : c0 + c1 v + ..., la constante d'abord ; inverse : c0/(v + c1) + c2.</translation>
    </message>
    <message>
        <source>position</source>
        <translation>position</translation>
    </message>
    <message>
        <source>position duties {} %, expected -100 to 100</source>
        <translation>rapports cycliques de position {} %, attendus de -100 à 100</translation>
    </message>
    <message>
        <source>position duty {}</source>
        <translation>rapport cyclique de position {}</translation>
    </message>
    <message>
        <source>precision {} mm: expected more than 0</source>
        <translation>précision {} mm : attendu plus de 0</translation>
    </message>
    <message>
        <source>predictor "{}": expected one of {}</source>
        <translation>prédicteur "{}" : un parmi {} attendu</translation>
    </message>
    <message>
        <source>predictor "{}": expected one of {}, {}</source>
        <translation>prédicteur "{}" : attendu un de {}, {}</translation>
    </message>
    <message>
        <source>preparing %1 triangles…</source>
        <translation>préparation de %1 triangles…</translation>
    </message>
    <message>
        <source>preset %1</source>
        <translation>préréglage %1</translation>
    </message>
    <message>
        <source>preset '{}': expected a name of 1 to {} letters, digits, spaces, '-' or '_', with no space at its ends</source>
        <translation>préréglage '{}' : attendu un nom de 1 à {} lettres, chiffres, espaces, '-' ou '_', sans espace aux bords</translation>
    </message>
    <message>
        <source>preset '{}': there is one of this name; delete it first or choose another name</source>
        <translation>préréglage '{}' : il y en a un de ce nom ; le supprimer d'abord ou choisir un autre nom</translation>
    </message>
    <message>
        <source>press slower, and hold each depth</source>
        <translation>appuyer plus lentement, et tenir chaque profondeur</translation>
    </message>
    <message>
        <source>pressed down by</source>
        <translation>enfoncé de</translation>
    </message>
    <message>
        <source>probe: {} is {}; expected a number above 0</source>
        <translation>sonde : {} vaut {} ; attendu un nombre supérieur à 0</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>proposé</translation>
    </message>
    <message>
        <source>put in</source>
        <translation>apportée</translation>
    </message>
    <message>
        <source>quick stop active</source>
        <translation>arrêt rapide en cours</translation>
    </message>
    <message>
        <source>radius share</source>
        <translation>part du rayon</translation>
    </message>
    <message>
        <source>radius share %1 ± %2</source>
        <translation>part du rayon %1 ± %2</translation>
    </message>
    <message>
        <source>rate = {} Hz: expected more than 0</source>
        <translation>fréquence = {} Hz : attendu plus de 0</translation>
    </message>
    <message>
        <source>rate = {} Hz: expected {} … {}</source>
        <translation>fréquence = {} Hz : attendu {} … {}</translation>
    </message>
    <message>
        <source>reach_mm of a soft body is {}; expected more than 0</source>
        <translation>reach_mm d'un corps mou est {} ; attendu plus de 0</translation>
    </message>
    <message>
        <source>reachable</source>
        <translation>atteignable</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>lecture</translation>
    </message>
    <message>
        <source>reading not a number</source>
        <translation>lecture qui n'est pas un nombre</translation>
    </message>
    <message>
        <source>readings too unsteady</source>
        <translation>lectures trop instables</translation>
    </message>
    <message>
        <source>ready to switch on</source>
        <translation>prêt à s'allumer</translation>
    </message>
    <message>
        <source>recorded at {} Hz: {} Hz is less than 1/{} of that</source>
        <translation>enregistré à {} Hz : {} Hz est moins que 1/{} de cela</translation>
    </message>
    <message>
        <source>recorder crashed</source>
        <translation>enregistreur interrompu</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>enregistrement</translation>
    </message>
    <message>
        <source>recording of {} Hz at {} mm/s: no band of it can stand in a surface model</source>
        <translation>enregistrement de {} Hz à {} mm/s : aucune de ses bandes ne peut figurer dans un modèle de surface</translation>
    </message>
    <message>
        <source>recording of {} samples: expected at least {}</source>
        <translation>enregistrement de {} échantillons : attendu au moins {}</translation>
    </message>
    <message>
        <source>recording {}, {:.1f} s, played once; motors are not driven</source>
        <translation>enregistrement {}, {:.1f} s, lu une fois ; les moteurs ne sont pas commandés</translation>
    </message>
    <message>
        <source>recording {}, {} pictures, played once</source>
        <translation>enregistrement {}, {} images, lu une fois</translation>
    </message>
    <message>
        <source>recording {}: the count {} is beyond all measure</source>
        <translation>enregistrement {} : le compte {} est hors de toute mesure</translation>
    </message>
    <message>
        <source>recording's id '{}': expected 1 to 64 letters, digits or dashes</source>
        <translation>id de l'enregistrement '{}' : attendu 1 à 64 lettres, chiffres ou tirets</translation>
    </message>
    <message>
        <source>recording: no file name</source>
        <translation>enregistrement : pas de nom de fichier</translation>
    </message>
    <message>
        <source>recording: no vibration above {} Hz in it</source>
        <translation>enregistrement : pas de vibration au-dessus de {} Hz</translation>
    </message>
    <message>
        <source>recording: sample {} is {} g: expected {} … {}</source>
        <translation>enregistrement : l'échantillon {} vaut {} g : attendu {} … {}</translation>
    </message>
    <message>
        <source>recording: {} g around {} Hz: expected at most {} g</source>
        <translation>enregistrement : {} g autour de {} Hz : attendu au plus {} g</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>référence</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>refusé : %1</translation>
    </message>
    <message>
        <source>region {:.0f} × {:.0f} px</source>
        <translation>région {:.0f} × {:.0f} px</translation>
    </message>
    <message>
        <source>relay: the called side's address {} has no port</source>
        <translation>relais : l'adresse {} du côté appelé n'a pas de port</translation>
    </message>
    <message>
        <source>relay: {} stands on both sides; expected two addresses</source>
        <translation>relais : {} se trouve des deux côtés ; attendu deux adresses</translation>
    </message>
    <message>
        <source>renaming of preset %1</source>
        <translation>changement de nom du préréglage %1</translation>
    </message>
    <message>
        <source>repeatability %1</source>
        <translation>répétabilité %1</translation>
    </message>
    <message>
        <source>repeated</source>
        <translation>répété</translation>
    </message>
    <message>
        <source>repeated pictures</source>
        <translation>images répétées</translation>
    </message>
    <message>
        <source>resonance</source>
        <translation>résonance</translation>
    </message>
    <message>
        <source>resume</source>
        <translation>reprendre</translation>
    </message>
    <message>
        <source>rigidity_N_per_mm of a soft body is {}; expected more than 0</source>
        <translation>rigidity_N_per_mm d'un corps mou est {} ; attendu plus de 0</translation>
    </message>
    <message>
        <source>rings, then settles</source>
        <translation>oscille, puis s'établit</translation>
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
        <translation>robot '{}' : FYD Link a besoin d'un fichier de clé ; fyd link keygen en fait un</translation>
    </message>
    <message>
        <source>robot '{}': expected simulated, scene:FILE, none, link:HOST:PORT or classic:HOST:PORT</source>
        <translation>robot '{}' : attendu simulated, scene:FILE, none, link:HOST:PORT ou classic:HOST:PORT</translation>
    </message>
    <message>
        <source>robot '{}': takes no key file; only link:HOST:PORT does</source>
        <translation>robot '{}' : ne prend pas de fichier de clé ; seul link:HOST:PORT en prend un</translation>
    </message>
    <message>
        <source>robot end: known stiffness {} N/mm; expected 0 or more</source>
        <translation>côté robot : raideur connue {} N/mm ; attendu 0 ou plus</translation>
    </message>
    <message>
        <source>robot end: the touchpad's address {} has no port to call</source>
        <translation>côté robot : l'adresse {} du touchpad n'a pas de port à appeler</translation>
    </message>
    <message>
        <source>robot end: {}</source>
        <translation>côté robot : {}</translation>
    </message>
    <message>
        <source>robot end: {} cannot call {}: both must be IPv4 or both IPv6</source>
        <translation>côté robot : {} ne peut pas appeler {} : les deux doivent être IPv4 ou tous deux IPv6</translation>
    </message>
    <message>
        <source>robot end: {} states a second; expected 1 to 10000</source>
        <translation>côté robot : {} états par seconde ; attendu de 1 à 10000</translation>
    </message>
    <message>
        <source>robot target ({}, {}, {}) mm: expected three finite numbers</source>
        <translation>cible du robot ({}, {}, {}) mm : attendu trois nombres finis</translation>
    </message>
    <message>
        <source>row {}: position {} mm; expected one within ±{}, or NaN in a gap</source>
        <translation>ligne {} : position {} mm ; attendue à ±{} près, ou NaN dans une lacune</translation>
    </message>
    <message>
        <source>row {}: time {} s; expected one later than the row before</source>
        <translation>ligne {} : temps {} s ; un temps après celui de la ligne précédente attendu</translation>
    </message>
    <message>
        <source>row {}: {} events</source>
        <translation>ligne {} : {} événements</translation>
    </message>
    <message>
        <source>rows at its end that no sound commit proves: {}</source>
        <translation>lignes à sa fin qu'aucune validation saine ne prouve : {}</translation>
    </message>
    <message>
        <source>rows {}+{} of {}</source>
        <translation>lignes {}+{} sur {}</translation>
    </message>
    <message>
        <source>running</source>
        <translation>en cours</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>saturée</translation>
    </message>
    <message>
        <source>saved %1</source>
        <translation>enregistré %1</translation>
    </message>
    <message>
        <source>saved values are felt now; go back to the current ones to change any</source>
        <translation>les valeurs enregistrées sont ressenties ; revenir aux actuelles pour en changer</translation>
    </message>
    <message>
        <source>saving of preset %1</source>
        <translation>enregistrement du préréglage %1</translation>
    </message>
    <message>
        <source>scene '{}': the robot is a scene already, '{}'</source>
        <translation>scène '{}' : le robot est déjà une scène, '{}'</translation>
    </message>
    <message>
        <source>scene {}</source>
        <translation>scène {}</translation>
    </message>
    <message>
        <source>scene: {} meshes; expected {}, as there are bodies</source>
        <translation>scène : {} maillages ; attendu {}, autant que de corps</translation>
    </message>
    <message>
        <source>scene: {} models; expected {}, as there are bodies</source>
        <translation>scène : {} modèles ; attendu {}, autant que de corps</translation>
    </message>
    <message>
        <source>scene: {} textures; expected {}, as there are bodies</source>
        <translation>scène : {} textures ; attendu {}, autant que de corps</translation>
    </message>
    <message>
        <source>search text: {}</source>
        <translation>texte cherché : {}</translation>
    </message>
    <message>
        <source>search text: {} bytes, at most {} words are looked for</source>
        <translation>texte cherché : {} octets, au plus {} mots sont cherchés</translation>
    </message>
    <message>
        <source>second</source>
        <translation>second</translation>
    </message>
    <message>
        <source>second scale</source>
        <translation>échelle du second</translation>
    </message>
    <message>
        <source>second zero</source>
        <translation>zéro du second</translation>
    </message>
    <message>
        <source>send info and pause</source>
        <translation>envoyer les informations et pause</translation>
    </message>
    <message>
        <source>sensing.ir_offset_mm has {} values for {} sensors: tare first</source>
        <translation>sensing.ir_offset_mm a {} valeurs pour {} capteurs : faites d'abord la tare</translation>
    </message>
    <message>
        <source>sensor {} with {} codes and {} distances; expected 1 to {} and as many of each</source>
        <translation>capteur {} avec {} codes et {} distances ; attendu 1 à {} et autant de chaque</translation>
    </message>
    <message>
        <source>sensor: expected 0 to 8</source>
        <translation>sensor : attendu de 0 à 8</translation>
    </message>
    <message>
        <source>sensors contradict each other</source>
        <translation>les capteurs se contredisent</translation>
    </message>
    <message>
        <source>sensors: nothing received yet</source>
        <translation>capteurs : encore rien reçu</translation>
    </message>
    <message>
        <source>sent, not yet confirmed</source>
        <translation>envoyé, pas encore confirmé</translation>
    </message>
    <message>
        <source>serial number</source>
        <translation>numéro de série</translation>
    </message>
    <message>
        <source>session '': an empty id names no session</source>
        <translation>session '' : un identifiant vide ne désigne aucune session</translation>
    </message>
    <message>
        <source>session '{}': not in {}</source>
        <translation>session '{}' : pas dans {}</translation>
    </message>
    <message>
        <source>session '{}': several begin so; give more digits</source>
        <translation>session '{}' : plusieurs commencent ainsi ; donner plus de chiffres</translation>
    </message>
    <message>
        <source>session time, s</source>
        <translation>temps session, s</translation>
    </message>
    <message>
        <source>set to {:.0f} %</source>
        <translation>réglé à {:.0f} %</translation>
    </message>
    <message>
        <source>settles</source>
        <translation>s'établit</translation>
    </message>
    <message>
        <source>several</source>
        <translation>plusieurs</translation>
    </message>
    <message>
        <source>silent</source>
        <translation>silencieux</translation>
    </message>
    <message>
        <source>silent; is it plugged in and switched on?</source>
        <translation>silencieux ; est-il branché et allumé ?</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simulé</translation>
    </message>
    <message>
        <source>simulated camera</source>
        <translation>caméra simulée</translation>
    </message>
    <message>
        <source>simulated camera, 320 × 240 at {:.0f} fps</source>
        <translation>caméra simulée, 320 × 240 à {:.0f} i/s</translation>
    </message>
    <message>
        <source>simulated robot on {}</source>
        <translation>robot simulé sur {}</translation>
    </message>
    <message>
        <source>simulated touchpad, seed {}</source>
        <translation>touchpad simulé, graine {}</translation>
    </message>
    <message>
        <source>simulated touchpad: nothing to serve it through</source>
        <translation>touchpad simulé : rien par quoi le servir</translation>
    </message>
    <message>
        <source>skipped</source>
        <translation>omise</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>pente</translation>
    </message>
    <message>
        <source>slope fits force against indentation with uncertainty; thesis is the bare ratio.</source>
        <translation>slope ajuste la force à l'indentation avec incertitude ; thesis est le simple rapport.</translation>
    </message>
    <message>
        <source>slope per angle, monotone law</source>
        <translation>pente par angle, loi monotone</translation>
    </message>
    <message>
        <source>smoothing of {} ms: expected 0 to 1000</source>
        <translation>lissage de {} ms : attendu 0 à 1000</translation>
    </message>
    <message>
        <source>smoothing {} ms: expected 0 … 1000</source>
        <translation>lissage de {} ms : attendu 0 … 1000</translation>
    </message>
    <message>
        <source>solid</source>
        <translation>continu</translation>
    </message>
    <message>
        <source>speed = {} mm/s: expected {} … {}, or none when it is unknown</source>
        <translation>speed = {} mm/s : attendu {} … {}, ou rien si elle est inconnue</translation>
    </message>
    <message>
        <source>speed limit {} mm/s: expected 1 to 1000</source>
        <translation>limite de vitesse {} mm/s : attendu de 1 à 1000</translation>
    </message>
    <message>
        <source>spread x %1, y %2, z %3</source>
        <translation>dispersion x %1, y %2, z %3</translation>
    </message>
    <message>
        <source>spread_mm of a soft body is {}; expected 0 or more</source>
        <translation>spread_mm d'un corps mou est {} ; attendu 0 ou plus</translation>
    </message>
    <message>
        <source>stale</source>
        <translation>périmé</translation>
    </message>
    <message>
        <source>stale answers</source>
        <translation>réponses périmées</translation>
    </message>
    <message>
        <source>start it</source>
        <translation>la lancer</translation>
    </message>
    <message>
        <source>started_utc: {}</source>
        <translation>started_utc : {}</translation>
    </message>
    <message>
        <source>state of {} bytes: damaged</source>
        <translation>état de {} octets : endommagé</translation>
    </message>
    <message>
        <source>state of {} bytes: expected at least {}</source>
        <translation>état de {} octets : attendu au moins {}</translation>
    </message>
    <message>
        <source>state of {} bytes: {}</source>
        <translation>état de {} octets : {}</translation>
    </message>
    <message>
        <source>state saved with another surface or scene; expected the same</source>
        <translation>état enregistré avec une autre surface ou une autre scène ; la même était attendue</translation>
    </message>
    <message>
        <source>state with {} bytes of content: expected {}</source>
        <translation>état avec {} octets de contenu : attendu {}</translation>
    </message>
    <message>
        <source>status word</source>
        <translation>mot d'état</translation>
    </message>
    <message>
        <source>stiffness falls from {:.3f} N/mm at {:.3g} deg to {:.3f} at {:.3g} deg, though stretching stiffens the cloth: press at both angles again, and look whether the cloth slips</source>
        <translation>la raideur tombe de {:.3f} N/mm à {:.3g}° à {:.3f} à {:.3g}°, alors que l'étirement raidit le tissu : presser de nouveau aux deux angles et voir si le tissu glisse</translation>
    </message>
    <message>
        <source>stiffness known to about %1 %</source>
        <translation>raideur connue à environ %1 %</translation>
    </message>
    <message>
        <source>still being recorded</source>
        <translation>encore en cours d'enregistrement</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>arrêté</translation>
    </message>
    <message>
        <source>stream</source>
        <translation>flux</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>étirement</translation>
    </message>
    <message>
        <source>stretch {:g}°: beyond control.motor_limit_deg = {:.0f}</source>
        <translation>étirement {:g}° : au-delà de control.motor_limit_deg = {:.0f}</translation>
    </message>
    <message>
        <source>subject "{}": expected a code of letters, digits, - and _ such as S07, at most {} characters; never a name</source>
        <translation>sujet "{}" : attendu un code de lettres, chiffres, - et _ comme S07, au plus {} caractères ; jamais un nom</translation>
    </message>
    <message>
        <source>subject %1</source>
        <translation>sujet %1</translation>
    </message>
    <message>
        <source>supply undervoltage</source>
        <translation>sous-tension de l'alimentation</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>balayage</translation>
    </message>
    <message>
        <source>switch-on disabled</source>
        <translation>mise en marche inhibée</translation>
    </message>
    <message>
        <source>switched off by itself</source>
        <translation>coupée d'elle-même</translation>
    </message>
    <message>
        <source>switched on</source>
        <translation>allumé</translation>
    </message>
    <message>
        <source>tag '{}': empty</source>
        <translation>étiquette '{}' : vide</translation>
    </message>
    <message>
        <source>tags: {}, at most {} are catalogued</source>
        <translation>étiquettes : {}, au plus {} sont cataloguées</translation>
    </message>
    <message>
        <source>take points first</source>
        <translation>prendre d'abord des points</translation>
    </message>
    <message>
        <source>take the hand away and start again</source>
        <translation>éloigner la main et recommencer</translation>
    </message>
    <message>
        <source>take the weights off again one by one to see drift and hysteresis</source>
        <translation>retirer les poids un à un pour voir dérive et hystérésis</translation>
    </message>
    <message>
        <source>taken</source>
        <translation>pris</translation>
    </message>
    <message>
        <source>taken with another curve: take it again</source>
        <translation>pris avec une autre courbe : les reprendre</translation>
    </message>
    <message>
        <source>target</source>
        <translation>consigne</translation>
    </message>
    <message>
        <source>target limited</source>
        <translation>consigne limitée</translation>
    </message>
    <message>
        <source>temperature {}</source>
        <translation>température {}</translation>
    </message>
    <message>
        <source>tension ratio</source>
        <translation>rapport de tension</translation>
    </message>
    <message>
        <source>tension ratio %1 ± %2</source>
        <translation>rapport de tension %1 ± %2</translation>
    </message>
    <message>
        <source>the axes stand {:.1f} deg from a right angle: the camera looks at the cloth aslant</source>
        <translation>les axes s'écartent de {:.1f}° d'un angle droit : la caméra regarde le tissu de biais</translation>
    </message>
    <message>
        <source>the block changed while it was read (its two sequence numbers differ)</source>
        <translation>le bloc a changé pendant sa lecture (ses deux numéros de séquence diffèrent)</translation>
    </message>
    <message>
        <source>the camera is %1 ± %2 below the cloth</source>
        <translation>la caméra est à %1 ± %2 sous le tissu</translation>
    </message>
    <message>
        <source>the camera sees a finger on the cloth: take everything off</source>
        <translation>la caméra voit un doigt sur le tissu : tout retirer</translation>
    </message>
    <message>
        <source>the camera sees no finger: press the cloth over a distance sensor</source>
        <translation>la caméra ne voit pas de doigt : appuyer sur le tissu au-dessus d'un capteur de distance</translation>
    </message>
    <message>
        <source>the camera sees nothing: picture black, white, of one grey, empty or in an unknown light</source>
        <translation>la caméra ne voit rien : image noire, blanche, d'un seul gris, vide ou de lumière inconnue</translation>
    </message>
    <message>
        <source>the camera sends no pictures</source>
        <translation>la caméra n'envoie pas d'image</translation>
    </message>
    <message>
        <source>the camera shows no cloth: look under Devices whether it answers</source>
        <translation>la caméra ne montre pas le tissu : voir dans Appareils si elle répond</translation>
    </message>
    <message>
        <source>the camera's height is known only to {:.0f} %; expected at most {:g} %</source>
        <translation>la hauteur de la caméra n'est connue qu'à {:.0f} % ; attendu au plus {:g} %</translation>
    </message>
    <message>
        <source>the cloth was touched</source>
        <translation>le tissu a été touché</translation>
    </message>
    <message>
        <source>the columns differ in length</source>
        <translation>les colonnes n'ont pas la même longueur</translation>
    </message>
    <message>
        <source>the commits that were there have gone</source>
        <translation>les validations qui y étaient ont disparu</translation>
    </message>
    <message>
        <source>the deepest press over distance sensor {} is {:.2f} mm; expected at least {:g} mm: press deeper there</source>
        <translation>l'appui le plus profond au-dessus du capteur de distance {} est de {:.2f} mm ; attendu au moins {:g} mm : appuyez-y plus profond</translation>
    </message>
    <message>
        <source>the depths do not tell the camera's height</source>
        <translation>les profondeurs ne disent pas la hauteur de la caméra</translation>
    </message>
    <message>
        <source>the disk has less than {:.0f} MB left: recording stopped</source>
        <translation>il reste moins de {:.0f} Mo sur le disque : enregistrement arrêté</translation>
    </message>
    <message>
        <source>the disk: one commit changes more than the journal holds</source>
        <translation>le disque : une validation change plus que le journal ne contient</translation>
    </message>
    <message>
        <source>the disk: {}</source>
        <translation>le disque : {}</translation>
    </message>
    <message>
        <source>the distance sensors are silent</source>
        <translation>les capteurs de distance sont silencieux</translation>
    </message>
    <message>
        <source>the distance sensors repeat the codes {} although their count goes on: switch the touchpad off and on</source>
        <translation>les capteurs de distance répètent les codes {} bien que leur compte avance : éteindre et rallumer le touchpad</translation>
    </message>
    <message>
        <source>the distances span only {:.3g} mm, {:g} to {:g}; expected at least {:g}: add points between {:g} and {:g} mm</source>
        <translation>les distances ne couvrent que {:.3g} mm, de {:g} à {:g} ; il en faut au moins {:g} : ajouter des points entre {:g} et {:g} mm</translation>
    </message>
    <message>
        <source>the finger is {:.1f} mm beside distance sensor {}, at most {:g} mm count: move it to {:.0f}, {:.0f} mm</source>
        <translation>le doigt est à {:.1f} mm à côté du capteur de distance {}, seuls comptent {:g} mm au plus : le déplacer vers {:.0f}, {:.0f} mm</translation>
    </message>
    <message>
        <source>the haptic loop stood still for more than 20 ms</source>
        <translation>la boucle haptique s'est arrêtée plus de 20 ms</translation>
    </message>
    <message>
        <source>the indentation was never proven on this cloth (fyd calibrate cloth): an indentation from the distance sensors can be wrong by 15 % and more, and the stiffness with it</source>
        <translation>l'indentation n'a jamais été prouvée sur ce tissu (fyd calibrate cloth) : une indentation tirée des capteurs de distance peut être fausse de 15 % et plus, et la raideur avec elle</translation>
    </message>
    <message>
        <source>the inverse form finds no curve through these points</source>
        <translation>la forme inverse ne trouve pas de courbe par ces points</translation>
    </message>
    <message>
        <source>the last %1 s</source>
        <translation>les %1 dernières s</translation>
    </message>
    <message>
        <source>the law is rising; beyond its ends the controller stays at them</source>
        <translation>la loi est croissante ; au-delà de ses bornes, la commande y reste</translation>
    </message>
    <message>
        <source>the load cell is silent</source>
        <translation>la cellule de charge est silencieuse</translation>
    </message>
    <message>
        <source>the load cell repeats {} mV/V although its count goes on: switch the touchpad off and on</source>
        <translation>la cellule de charge répète {} mV/V bien que son compte avance : éteindre et rallumer le touchpad</translation>
    </message>
    <message>
        <source>the load cell's value is outside its span</source>
        <translation>la valeur de la cellule de charge est hors de sa plage</translation>
    </message>
    <message>
        <source>the mesh has no triangle that has an area</source>
        <translation>le maillage n'a aucun triangle qui ait une aire</translation>
    </message>
    <message>
        <source>the millimetres lie on one line though the pixels do not: check the columns x_mm and y_mm</source>
        <translation>les millimètres sont sur une droite alors que les pixels n'y sont pas : vérifier les colonnes x_mm et y_mm</translation>
    </message>
    <message>
        <source>the motion goes beyond control.motor_limit_deg</source>
        <translation>le mouvement va au-delà de control.motor_limit_deg</translation>
    </message>
    <message>
        <source>the motors are in use: stop the session first</source>
        <translation>les moteurs sont utilisés : arrêter d'abord la session</translation>
    </message>
    <message>
        <source>the motors are silent</source>
        <translation>les moteurs sont silencieux</translation>
    </message>
    <message>
        <source>the motors do not answer</source>
        <translation>les moteurs ne répondent pas</translation>
    </message>
    <message>
        <source>the other end does not say that it holds this scene</source>
        <translation>l’autre extrémité ne dit pas qu’elle a cette scène</translation>
    </message>
    <message>
        <source>the other end holds a scene, this one none</source>
        <translation>l’autre extrémité a une scène, celle-ci aucune</translation>
    </message>
    <message>
        <source>the others contradict point %1</source>
        <translation>les autres contredisent le point %1</translation>
    </message>
    <message>
        <source>the outliers are kept in the fit; measure them again</source>
        <translation>les valeurs aberrantes restent dans l'ajustement ; les mesurer à nouveau</translation>
    </message>
    <message>
        <source>the picture has one grey value only: check the camera and the light</source>
        <translation>l'image n'a qu'un niveau de gris : vérifier la caméra et la lumière</translation>
    </message>
    <message>
        <source>the picture is frozen: the camera sends the same one again and again; unplug it and plug it in again</source>
        <translation>l'image est figée : la caméra envoie toujours la même ; la débrancher et la rebrancher</translation>
    </message>
    <message>
        <source>the ply header does not end</source>
        <translation>l'en-tête ply ne finit pas</translation>
    </message>
    <message>
        <source>the points at {:.3g} deg cannot be predicted from the others: press there again, to different depths</source>
        <translation>les points à {:.3g}° ne peuvent être prédits à partir des autres : presser encore là, à des profondeurs différentes</translation>
    </message>
    <message>
        <source>the points do not tell the unknowns apart (condition number {:.3g})</source>
        <translation>les points ne distinguent pas les inconnues (conditionnement {:.3g})</translation>
    </message>
    <message>
        <source>the points lie on one line in the picture: add points off that line, at the corners of the cloth</source>
        <translation>les points sont sur une droite dans l'image : ajouter des points hors de cette droite, aux coins du tissu</translation>
    </message>
    <message>
        <source>the presses over distance sensor {} are all about equally deep ({:.2f} to {:.2f} mm); expected {:g} times as deep at the deepest: press there at two depths</source>
        <translation>les appuis au-dessus du capteur de distance {} sont tous à peu près également profonds ({:.2f} à {:.2f} mm) ; attendu le plus profond {:g} fois autant : appuyez-y à deux profondeurs</translation>
    </message>
    <message>
        <source>the profile names no distance sensor: see sensing.ir_x_mm</source>
        <translation>le profil ne nomme aucun capteur de distance : voir sensing.ir_x_mm</translation>
    </message>
    <message>
        <source>the profile's values are another touchpad's: the defaults are used</source>
        <translation>les valeurs du profil sont celles d'un autre touchpad : les valeurs par défaut servent</translation>
    </message>
    <message>
        <source>the radius share {:.2f} is known only to {:.0f} % and the tension ratio {:.2f} to {:.0f} %; expected at most {:g} % and {:g} %: hold each press longer, so that its mean has less noise, and press deeper</source>
        <translation>la part du rayon {:.2f} n'est connue qu'à {:.0f} % et le rapport de tension {:.2f} à {:.0f} % ; attendu au plus {:g} % et {:g} % : tenez chaque appui plus longtemps, pour que sa moyenne ait moins de bruit, et appuyez plus profond</translation>
    </message>
    <message>
        <source>the reading drifts by {:.3f} N over the measurement: let the bridge warm up</source>
        <translation>la lecture dérive de {:.3f} N pendant la mesure : laisser chauffer le pont</translation>
    </message>
    <message>
        <source>the recorder is not running</source>
        <translation>l'enregistreur ne fonctionne pas</translation>
    </message>
    <message>
        <source>the recording holds no state of the step to start from: steps had been lost before it began; it can be looked at, not replayed</source>
        <translation>l'enregistrement ne contient pas d'état du pas d'où partir : des pas avaient été perdus avant son début ; on peut le regarder, pas le rejouer</translation>
    </message>
    <message>
        <source>the recording holds no step</source>
        <translation>l'enregistrement ne contient aucun pas</translation>
    </message>
    <message>
        <source>the recording is closed</source>
        <translation>l'enregistrement est fermé</translation>
    </message>
    <message>
        <source>the region is {} × {} px; expected at least {} px each way: drag a larger one</source>
        <translation>la région est de {} × {} px ; attendu au moins {} px de chaque côté : en tracer une plus grande</translation>
    </message>
    <message>
        <source>the robot has said goodbye</source>
        <translation>le robot a pris congé</translation>
    </message>
    <message>
        <source>the robot is silent</source>
        <translation>le robot est silencieux</translation>
    </message>
    <message>
        <source>the robot sends no acceleration: look at the link's panel</source>
        <translation>le robot n'envoie pas d'accélération : voir le panneau de la liaison</translation>
    </message>
    <message>
        <source>the robot's end has taken rest away before it sends: whether 1 g is 1 g is not seen here</source>
        <translation>le côté robot retire le repos avant d'envoyer : on ne voit pas ici si 1 g vaut 1 g</translation>
    </message>
    <message>
        <source>the robot's stiffness is not a number</source>
        <translation>la raideur du robot n'est pas un nombre</translation>
    </message>
    <message>
        <source>the session is closed</source>
        <translation>la session est fermée</translation>
    </message>
    <message>
        <source>the simulated touchpad</source>
        <translation>le touchpad simulé</translation>
    </message>
    <message>
        <source>the station uses %1 of its own accord</source>
        <translation>la station utilise %1 de sa propre initiative</translation>
    </message>
    <message>
        <source>the status word 0x{:04X} names no state</source>
        <translation>le mot d'état 0x{:04X} ne désigne aucun état</translation>
    </message>
    <message>
        <source>the step's input is farther away than 1e9 mm</source>
        <translation>une entrée du pas est à plus de 1e9 mm</translation>
    </message>
    <message>
        <source>the step's input is not a number</source>
        <translation>une entrée du pas n'est pas un nombre</translation>
    </message>
    <message>
        <source>the stiffness does not change with the angle: check that the motors stretch the cloth</source>
        <translation>la raideur ne change pas avec l'angle : vérifier que les moteurs étirent le tissu</translation>
    </message>
    <message>
        <source>the stretch is not known: look under Devices whether the motors answer</source>
        <translation>l'étirement est inconnu : voir sous Appareils si les moteurs répondent</translation>
    </message>
    <message>
        <source>the stretch lies outside control.travel_minimum_deg and control.travel_maximum_deg</source>
        <translation>l'étirement est hors de control.travel_minimum_deg et control.travel_maximum_deg</translation>
    </message>
    <message>
        <source>the temporary columns cannot be mapped: {}</source>
        <translation>les colonnes temporaires ne peuvent pas être projetées : {}</translation>
    </message>
    <message>
        <source>the temporary columns cannot be written: {}</source>
        <translation>les colonnes temporaires ne peuvent pas être écrites : {}</translation>
    </message>
    <message>
        <source>the three axes differ in length</source>
        <translation>les trois axes n'ont pas la même longueur</translation>
    </message>
    <message>
        <source>the time step is not between 1e-6 s and 1 s</source>
        <translation>la durée du pas n'est pas entre 1e-6 s et 1 s</translation>
    </message>
    <message>
        <source>the touchpad answers, but its clock or its count of value sets stands still: switch it off and on</source>
        <translation>le touchpad répond, mais son horloge ou son compte de jeux de valeurs est arrêté : l'éteindre et le rallumer</translation>
    </message>
    <message>
        <source>the touchpad closed the connection</source>
        <translation>le touchpad a fermé la connexion</translation>
    </message>
    <message>
        <source>the touchpad does not answer the call</source>
        <translation>le touchpad ne répond pas à l'appel</translation>
    </message>
    <message>
        <source>the touchpad does not obey what is written to it (bit 9 of its status word)</source>
        <translation>le touchpad n'obéit pas à ce qui lui est écrit (bit 9 de son mot d'état)</translation>
    </message>
    <message>
        <source>the touchpad renders, motors on</source>
        <translation>le touchpad rend, moteurs en marche</translation>
    </message>
    <message>
        <source>the touchpad restarted</source>
        <translation>le touchpad a redémarré</translation>
    </message>
    <message>
        <source>the touchpad was lost while its motors were being switched on</source>
        <translation>le touchpad a été perdu pendant la mise en marche de ses moteurs</translation>
    </message>
    <message>
        <source>the touchpad with serial number {}</source>
        <translation>le touchpad de numéro de série {}</translation>
    </message>
    <message>
        <source>the touchpad {}</source>
        <translation>le touchpad {}</translation>
    </message>
    <message>
        <source>the touchpad's motors are in the state {}</source>
        <translation>les moteurs du touchpad sont dans l'état {}</translation>
    </message>
    <message>
        <source>the two ends hold different scenes: open copies of one file</source>
        <translation>les deux extrémités ont des scènes différentes : ouvrir des copies du même fichier</translation>
    </message>
    <message>
        <source>the value does not follow the weight: check the cell's cable</source>
        <translation>la valeur ne suit pas le poids : vérifier le câble de la cellule</translation>
    </message>
    <message>
        <source>the value stays at {:.6g} mV/V whatever the weight: check the cell's cable and the bridge's channel</source>
        <translation>la valeur reste à {:.6g} mV/V quel que soit le poids : vérifier le câble de la cellule et la voie du pont</translation>
    </message>
    <message>
        <source>the values are too large to compute with</source>
        <translation>les valeurs sont trop grandes pour le calcul</translation>
    </message>
    <message>
        <source>the values do not fit this session</source>
        <translation>les valeurs ne conviennent pas à cette session</translation>
    </message>
    <message>
        <source>the weights span only {:.3g} N; expected at least {:g}: {}</source>
        <translation>les poids ne couvrent que {:.3g} N ; il en faut au moins {:g} : {}</translation>
    </message>
    <message>
        <source>the window did not answer for half a second</source>
        <translation>la fenêtre n'a pas répondu pendant une demi-seconde</translation>
    </message>
    <message>
        <source>the {} bytes are no whole {} file</source>
        <translation>les {} octets ne sont pas un fichier {} entier</translation>
    </message>
    <message>
        <source>there is no picture: look under Devices whether the camera answers</source>
        <translation>il n'y a pas d'image : voir dans Appareils si la caméra répond</translation>
    </message>
    <message>
        <source>there is no triangle in the {} bytes of this {} file</source>
        <translation>il n'y a aucun triangle dans les {} octets de ce fichier {}</translation>
    </message>
    <message>
        <source>these {} bytes are not a state of arithmetic 1</source>
        <translation>ces {} octets ne sont pas un état de l'arithmétique 1</translation>
    </message>
    <message>
        <source>these {} bytes are not the state of a pipeline</source>
        <translation>ces {} octets ne sont pas l'état d'un pipeline</translation>
    </message>
    <message>
        <source>thesis polynomial, scaled and shifted</source>
        <translation>polynôme de la thèse, mis à l'échelle et décalé</translation>
    </message>
    <message>
        <source>this camera has none, or refuses the value</source>
        <translation>cette caméra n'en a pas, ou refuse la valeur</translation>
    </message>
    <message>
        <source>this computer was late: {:.1f} % of the haptic cycles of that second were missed, longest gap {:.0f} ms; close other programs</source>
        <translation>cet ordinateur était en retard : {:.1f} % des cycles haptiques de cette seconde manqués, plus long écart {:.0f} ms ; fermer d'autres programmes</translation>
    </message>
    <message>
        <source>this part was never calibrated: accept a calibration first</source>
        <translation>cette partie n'a jamais été étalonnée : accepter d'abord un étalonnage</translation>
    </message>
    <message>
        <source>this source has none</source>
        <translation>cette source n'en a pas</translation>
    </message>
    <message>
        <source>time '{}': expected UTC as 2026-11-21, 2026-11-21T14:05 or 2026-11-21T14:05:09.250Z</source>
        <translation>temps '{}' : attendu UTC comme 2026-11-21, 2026-11-21T14:05 ou 2026-11-21T14:05:09.250Z</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>temps (s)</translation>
    </message>
    <message>
        <source>time limit reached</source>
        <translation>limite de temps atteinte</translation>
    </message>
    <message>
        <source>time_s is no number</source>
        <translation>time_s n'est pas un nombre</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>tolerance of a soft body is {}; expected between 0 and 1</source>
        <translation>tolerance d'un corps mou est {} ; attendu entre 0 et 1</translation>
    </message>
    <message>
        <source>too far behind</source>
        <translation>trop en retard</translation>
    </message>
    <message>
        <source>too few distance sensors read within their span</source>
        <translation>trop peu de capteurs de distance lisent dans leur plage</translation>
    </message>
    <message>
        <source>too few readings beside the finger: at least two sensors must read in each press</source>
        <translation>trop peu de lectures à côté du doigt : au moins deux capteurs doivent lire à chaque appui</translation>
    </message>
    <message>
        <source>too few readings in time</source>
        <translation>trop peu de lectures à temps</translation>
    </message>
    <message>
        <source>too few valid sensors</source>
        <translation>trop peu de capteurs valides</translation>
    </message>
    <message>
        <source>too small</source>
        <translation>trop petit</translation>
    </message>
    <message>
        <source>too small to turn</source>
        <translation>trop faible pour tourner</translation>
    </message>
    <message>
        <source>too uncertain</source>
        <translation>trop incertain</translation>
    </message>
    <message>
        <source>tool force</source>
        <translation>force sur l'outil</translation>
    </message>
    <message>
        <source>tool torque</source>
        <translation>couple sur l'outil</translation>
    </message>
    <message>
        <source>torn blocks</source>
        <translation>blocs incohérents</translation>
    </message>
    <message>
        <source>touch %1 at %2 s</source>
        <translation>toucher %1 à %2 s</translation>
    </message>
    <message>
        <source>touch from {:.3f} to {:.3f} s: {} pictures show its finger; expected two and more</source>
        <translation>toucher de {:.3f} à {:.3f} s : {} images montrent son doigt ; deux ou plus attendues</translation>
    </message>
    <message>
        <source>touchpad %1</source>
        <translation>touchpad %1</translation>
    </message>
    <message>
        <source>touchpad '{}': expected simulated, serial:NUMBER of 1 to {} characters, or its address</source>
        <translation>touchpad '{}' : attendu simulated, serial:NUMÉRO de 1 à {} caractères, ou son adresse</translation>
    </message>
    <message>
        <source>touchpad at {}</source>
        <translation>touchpad sur {}</translation>
    </message>
    <message>
        <source>touchpad {}</source>
        <translation>touchpad {}</translation>
    </message>
    <message>
        <source>touchpad {}, firmware {}.{}, at {}</source>
        <translation>touchpad {}, micrologiciel {}.{}, sur {}</translation>
    </message>
    <message>
        <source>trial begins</source>
        <translation>l'essai commence</translation>
    </message>
    <message>
        <source>trial ends</source>
        <translation>l'essai finit</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>unacceptable</source>
        <translation>inacceptable</translation>
    </message>
    <message>
        <source>under 1 min left</source>
        <translation>moins de 1 min</translation>
    </message>
    <message>
        <source>unexpected argument '{}'; --help shows the options</source>
        <translation>argument inattendu '{}' ; --help montre les options</translation>
    </message>
    <message>
        <source>unexpected kind</source>
        <translation>type inattendu</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>unknown command</source>
        <translation>commande inconnue</translation>
    </message>
    <message>
        <source>unknown fault</source>
        <translation>défaut inconnu</translation>
    </message>
    <message>
        <source>unknown parameter '{}'</source>
        <translation>paramètre inconnu '{}'</translation>
    </message>
    <message>
        <source>unknown parameter '{}'; a replay changes the step's only</source>
        <translation>paramètre inconnu '{}' ; une réexécution ne change que ceux du pas</translation>
    </message>
    <message>
        <source>unknown problem</source>
        <translation>problème inconnu</translation>
    </message>
    <message>
        <source>unknown state, quality or strategy</source>
        <translation>état, qualité ou stratégie inconnus</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>instable</translation>
    </message>
    <message>
        <source>untouched</source>
        <translation>non touché</translation>
    </message>
    <message>
        <source>up and down</source>
        <translation>en haut et en bas</translation>
    </message>
    <message>
        <source>usable</source>
        <translation>utilisable</translation>
    </message>
    <message>
        <source>use DFT321</source>
        <translation>utiliser DFT321</translation>
    </message>
    <message>
        <source>use SoC</source>
        <translation>utiliser SoC</translation>
    </message>
    <message>
        <source>valid from %1 to %2</source>
        <translation>valable de %1 à %2</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valeur</translation>
    </message>
    <message>
        <source>values is missing</source>
        <translation>values manque</translation>
    </message>
    <message>
        <source>vibration</source>
        <translation>vibration</translation>
    </message>
    <message>
        <source>vibration down</source>
        <translation>moins de vibration</translation>
    </message>
    <message>
        <source>vibration duties lost here</source>
        <translation>rapports de vibration perdus ici</translation>
    </message>
    <message>
        <source>vibration duties lost there</source>
        <translation>rapports de vibration perdus là-bas</translation>
    </message>
    <message>
        <source>vibration up</source>
        <translation>plus de vibration</translation>
    </message>
    <message>
        <source>video file</source>
        <translation>fichier vidéo</translation>
    </message>
    <message>
        <source>video file '{}'</source>
        <translation>fichier vidéo '{}'</translation>
    </message>
    <message>
        <source>viscosity_Ns_per_mm of a soft body is {}; expected 0 or more</source>
        <translation>viscosity_Ns_per_mm d'un corps mou est {} ; attendu 0 ou plus</translation>
    </message>
    <message>
        <source>wait until it is done</source>
        <translation>attendre qu'elle soit finie</translation>
    </message>
    <message>
        <source>waiting for a robot on {}</source>
        <translation>en attente d'un robot sur {}</translation>
    </message>
    <message>
        <source>wall {} N/m: expected 0 (none) … 20000</source>
        <translation>paroi de {} N/m : attendu 0 (aucune) … 20000</translation>
    </message>
    <message>
        <source>wanted</source>
        <translation>voulu</translation>
    </message>
    <message>
        <source>was %1</source>
        <translation>était %1</translation>
    </message>
    <message>
        <source>was lost while its motors were on</source>
        <translation>a été perdue pendant que ses moteurs étaient en marche</translation>
    </message>
    <message>
        <source>was switched off because its command was not renewed in time</source>
        <translation>a été coupée parce que sa commande n'a pas été renouvelée à temps</translation>
    </message>
    <message>
        <source>what if</source>
        <translation>et si</translation>
    </message>
    <message>
        <source>whole</source>
        <translation>entière</translation>
    </message>
    <message>
        <source>width</source>
        <translation>largeur</translation>
    </message>
    <message>
        <source>with the other edges %1</source>
        <translation>avec les autres bords %1</translation>
    </message>
    <message>
        <source>withheld</source>
        <translation>retenue</translation>
    </message>
    <message>
        <source>workspace {} x {} x {} mm at {} mm: more than {} points on an axis</source>
        <translation>espace de travail {} x {} x {} mm à {} mm : plus de {} points sur un axe</translation>
    </message>
    <message>
        <source>workspace {} x {} x {} mm: every side must be longer than 0</source>
        <translation>espace de travail {} x {} x {} mm : chaque côté doit dépasser 0</translation>
    </message>
    <message>
        <source>workspace ±({}, {}, {}) mm: expected three numbers above 0</source>
        <translation>espace de travail ±({}, {}, {}) mm : attendu trois nombres au-dessus de 0</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>écriture</translation>
    </message>
    <message>
        <source>wrong button</source>
        <translation>bouton erroné</translation>
    </message>
    <message>
        <source>wrong id</source>
        <translation>mauvais id</translation>
    </message>
    <message>
        <source>wrong key or damaged</source>
        <translation>mauvaise clé ou endommagé</translation>
    </message>
    <message>
        <source>wrong separator</source>
        <translation>séparateur erroné</translation>
    </message>
    <message>
        <source>wrong sign</source>
        <translation>signe erroné</translation>
    </message>
    <message>
        <source>wrong size</source>
        <translation>taille erronée</translation>
    </message>
    <message>
        <source>wrong size field</source>
        <translation>mauvais champ de taille</translation>
    </message>
    <message>
        <source>wrong start or end mark</source>
        <translation>marque de début ou de fin erronée</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>x %1 mm   y %2 mm   area %3 mm²</source>
        <translation>x %1 mm   y %2 mm   aire %3 mm²</translation>
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
        <translation>x, vers la droite</translation>
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
        <translation>y, vers le fond</translation>
    </message>
    <message>
        <source>your name: the record keeps it</source>
        <translation>votre nom : le procès-verbal le garde</translation>
    </message>
    <message>
        <source>z, g</source>
        <translation>z, g</translation>
    </message>
    <message>
        <source>{:.1f} % of the picture is dark; a finger takes {:.1f} to {:.0f} %: check the region of interest</source>
        <translation>{:.1f} % de l'image sont sombres ; un doigt en prend {:.1f} à {:.0f} % : vérifier la région d'intérêt</translation>
    </message>
    <message>
        <source>{:.3f} N/mm at {:.3g} deg is known only to {:.0f} %; expected at most {:g} %: press there more often and deeper</source>
        <translation>{:.3f} N/mm à {:.3g}° n'est connu qu'à {:.0f} % près ; attendu au plus {:g} % : y presser plus souvent et plus fort</translation>
    </message>
    <message>
        <source>{:.3f} mV/V is beyond the load cell's span of {:g}</source>
        <translation>{:.3f} mV/V dépasse la plage de la cellule de charge de {:g}</translation>
    </message>
    <message>
        <source>{} = "{}": expected {}</source>
        <translation>{} = « {} » : attendu {}</translation>
    </message>
    <message>
        <source>{} = '{}': expected true or false</source>
        <translation>{} = '{}' : attendu true ou false</translation>
    </message>
    <message>
        <source>{} = '{}': expected {}</source>
        <translation>{} = '{}' : attendu {}</translation>
    </message>
    <message>
        <source>{} = {} was refused.</source>
        <translation>{} = {} a été refusé.</translation>
    </message>
    <message>
        <source>{} = {}: expected a list such as [1, 2]</source>
        <translation>{} = {} : attendu une liste comme [1, 2]</translation>
    </message>
    <message>
        <source>{} = {}: expected a number from {} to {}; correct or delete the row</source>
        <translation>{} = {} : attendu un nombre de {} à {} ; corriger ou supprimer la ligne</translation>
    </message>
    <message>
        <source>{} = {}: expected {}</source>
        <translation>{} = {} : attendu {}</translation>
    </message>
    <message>
        <source>{} angles are not told apart by their stiffness and were pooled</source>
        <translation>{} angles ne se distinguent pas par leur raideur et ont été réunis</translation>
    </message>
    <message>
        <source>{} axes; expected 1 to {}</source>
        <translation>{} axes ; attendu de 1 à {}</translation>
    </message>
    <message>
        <source>{} by the operator. Motors are off. Arm to start again.</source>
        <translation>{} par l'opérateur. Moteurs coupés. Armer pour recommencer.</translation>
    </message>
    <message>
        <source>{} bytes are not a scene: {}</source>
        <translation>{} octets ne sont pas une scène : {}</translation>
    </message>
    <message>
        <source>{} bytes at once</source>
        <translation>{} octets à la fois</translation>
    </message>
    <message>
        <source>{} bytes cannot be compressed ({})</source>
        <translation>{} octets ne peuvent pas être compressés ({})</translation>
    </message>
    <message>
        <source>{} cannot be drawn: {}</source>
        <translation>{} ne peut pas être dessiné : {}</translation>
    </message>
    <message>
        <source>{} cannot change while the station runs</source>
        <translation>{} ne peut pas changer pendant que la station fonctionne</translation>
    </message>
    <message>
        <source>{} chirps, stretches {} ° apart; expected two or more chirps, {} ° apart</source>
        <translation>{} balayages, étirements écartés de {} ° ; attendu deux balayages ou plus, écartés de {} °</translation>
    </message>
    <message>
        <source>{} conditions: expected 1 … {}</source>
        <translation>{} conditions : attendu 1 … {}</translation>
    </message>
    <message>
        <source>{} different angles; expected at least {}: add presses at an angle between {:.3g} and {:.3g} deg</source>
        <translation>{} angles différents ; il en faut au moins {} : ajouter des pressions à un angle entre {:.3g} et {:.3g}°</translation>
    </message>
    <message>
        <source>{} different distances in {} points; expected at least {}: add points between {:g} and {:g} mm (the same distance again tells only the noise)</source>
        <translation>{} distances différentes en {} points ; il en faut au moins {} : ajouter des points entre {:g} et {:g} mm (la même distance répétée ne donne que le bruit)</translation>
    </message>
    <message>
        <source>{} different points; expected at least {}: add points, best at the corners of the cloth</source>
        <translation>{} points différents ; il en faut au moins {} : ajouter des points, de préférence aux coins du tissu</translation>
    </message>
    <message>
        <source>{} different weights in {} points; expected at least {}: {}</source>
        <translation>{} poids différents en {} points ; il en faut au moins {} : {}</translation>
    </message>
    <message>
        <source>{} distances; needs {}</source>
        <translation>{} distances ; il en faut {}</translation>
    </message>
    <message>
        <source>{} does not answer: {}</source>
        <translation>{} ne répond pas : {}</translation>
    </message>
    <message>
        <source>{} encoder turns {:.1f} % {} than commanded; expected within {:g} %: check that the motor is free, and that both are wired to the same roller</source>
        <translation>le codeur {} tourne {:.1f} % {} que commandé ; attendu à {:g} % près : vérifier que le moteur est libre et que les deux sont câblés au même rouleau</translation>
    </message>
    <message>
        <source>{} encoder: {}</source>
        <translation>codeur {} : {}</translation>
    </message>
    <message>
        <source>{} encoder: {} points over {:.3g} deg; expected at least 5 over {:g} deg: sweep farther</source>
        <translation>codeur {} : {} points sur {:.3g}° ; il en faut au moins 5 sur {:g}° : balayer plus loin</translation>
    </message>
    <message>
        <source>{} had {} values when the state was saved, here it has {}; expected the same</source>
        <translation>{} avait {} valeurs quand l'état fut enregistré, ici il en a {} ; attendu le même nombre</translation>
    </message>
    <message>
        <source>{} is another kind of parameter in this program</source>
        <translation>{} est un paramètre d'une autre sorte dans ce programme</translation>
    </message>
    <message>
        <source>{} is lost for {} steps from row {} on ({})</source>
        <translation>{} est perdu pour {} pas à partir de la ligne {} ({})</translation>
    </message>
    <message>
        <source>{} is missing</source>
        <translation>{} manque</translation>
    </message>
    <message>
        <source>{} is not known: check its cable</source>
        <translation>{} n'est pas connu : vérifier son câble</translation>
    </message>
    <message>
        <source>{} is now {:.4g}.</source>
        <translation>{} vaut maintenant {:.4g}.</translation>
    </message>
    <message>
        <source>{} is now {}.</source>
        <translation>{} vaut maintenant {}.</translation>
    </message>
    <message>
        <source>{} is stored, its notes are not: {}</source>
        <translation>{} est rangé, ses notes ne le sont pas : {}</translation>
    </message>
    <message>
        <source>{} of {} presses are more than {:g} mm beside a sensor (up to {:.1f} mm), or over one that does not read; they tell no depth and were left out</source>
        <translation>{} appuis sur {} sont à plus de {:g} mm d'un capteur (jusqu'à {:.1f} mm), ou au-dessus d'un qui ne lit pas ; ils ne disent aucune profondeur et ont été laissés de côté</translation>
    </message>
    <message>
        <source>{} parameters change with the first step, those of the recording included; a step takes at most {}: set fewer at once</source>
        <translation>{} paramètres changent avec le premier pas, ceux de l'enregistrement compris ; un pas en prend au plus {} : en régler moins à la fois</translation>
    </message>
    <message>
        <source>{} points at {:.3g} deg are at least {:g} mm deep; expected at least {}: press there again, to different depths</source>
        <translation>{} points à {:.3g}° ont au moins {:g} mm de profondeur ; il en faut au moins {} : presser encore là, à des profondeurs différentes</translation>
    </message>
    <message>
        <source>{} points for a {}; expected at least {}</source>
        <translation>{} points pour {} ; attendu au moins {}</translation>
    </message>
    <message>
        <source>{} points for {} unknowns; expected at least as many</source>
        <translation>{} points pour {} inconnues ; attendu au moins autant</translation>
    </message>
    <message>
        <source>{} points; at most {}: take fewer, or means</source>
        <translation>{} points ; au plus {} : en prendre moins, ou des moyennes</translation>
    </message>
    <message>
        <source>{} points; the camera's height takes at least {}: at the cloth's corners, some on the untouched cloth and some pressed down</source>
        <translation>{} points ; la hauteur de la caméra en demande au moins {} : aux coins du tissu, certains sur le tissu non touché et certains enfoncés</translation>
    </message>
    <message>
        <source>{} positions for {} times; expected one for each</source>
        <translation>{} positions pour {} temps ; une attendue pour chacun</translation>
    </message>
    <message>
        <source>{} presses; at most {}: take the mean of each press</source>
        <translation>{} appuis ; au plus {} : prenez la moyenne de chaque appui</translation>
    </message>
    <message>
        <source>{} repetitions: expected 1 … {}</source>
        <translation>{} répétitions : attendu 1 … {}</translation>
    </message>
    <message>
        <source>{} rows of {} are gone before its row {} ({})</source>
        <translation>{} lignes de {} manquent avant sa ligne {} ({})</translation>
    </message>
    <message>
        <source>{} rows, none of them with a position; expected one and more</source>
        <translation>{} lignes, aucune avec une position ; une ou plus attendues</translation>
    </message>
    <message>
        <source>{} rows; expected two and more</source>
        <translation>{} lignes ; deux ou plus attendues</translation>
    </message>
    <message>
        <source>{} s at {} Hz are {} samples: expected at most {}</source>
        <translation>{} s à {} Hz font {} échantillons : attendu au plus {}</translation>
    </message>
    <message>
        <source>{} s from the first row to the last; expected at most {}: are the times in seconds?</source>
        <translation>{} s de la première ligne à la dernière ; attendu : {} au plus ; les temps sont-ils en secondes ?</translation>
    </message>
    <message>
        <source>{} samples; expected at least {}: wait longer</source>
        <translation>{} échantillons ; attendu au moins {} : attendre plus longtemps</translation>
    </message>
    <message>
        <source>{} spans only {:.3g} px; expected at least {:g}: add points farther {}</source>
        <translation>{} ne couvre que {:.3g} px ; attendu au moins {:g} : ajouter des points plus éloignés {}</translation>
    </message>
    <message>
        <source>{} steps are not committed yet</source>
        <translation>{} pas ne sont pas encore validés</translation>
    </message>
    <message>
        <source>{} steps were lost</source>
        <translation>{} pas ont été perdus</translation>
    </message>
    <message>
        <source>{} triangles; at most {} can be touched</source>
        <translation>{} triangles ; on peut en toucher au plus {}</translation>
    </message>
    <message>
        <source>{} values and {} forces; expected as many of each</source>
        <translation>{} valeurs et {} forces ; attendu autant de chaque</translation>
    </message>
    <message>
        <source>{} values and {} weights for {} points</source>
        <translation>{} valeurs et {} poids pour {} points</translation>
    </message>
    <message>
        <source>{} vertices; at most {} can be counted</source>
        <translation>{} sommets ; on peut en compter au plus {}</translation>
    </message>
    <message>
        <source>{} was {} when the state was saved, here it is {}; expected the same</source>
        <translation>{} valait {} quand l'état fut enregistré, ici il vaut {} ; attendu le même</translation>
    </message>
    <message>
        <source>{} × {} pixels, expected at most {}</source>
        <translation>{} × {} pixels, attendu au plus {}</translation>
    </message>
    <message>
        <source>{} × {} pixels, expected {} × {}</source>
        <translation>{} × {} pixels, attendu {} × {}</translation>
    </message>
    <message>
        <source>{}'s newest reading is {:.0f} ms old</source>
        <translation>la lecture la plus récente de {} a {:.0f} ms</translation>
    </message>
    <message>
        <source>{}, from line {}: {}</source>
        <translation>{}, à partir de la ligne {} : {}</translation>
    </message>
    <message>
        <source>{}, line {}: expected "{}"</source>
        <translation>{}, ligne {} : attendu « {} »</translation>
    </message>
    <message>
        <source>{}, {} at {:.4g} fps, repeating</source>
        <translation>{}, {} à {:.4g} i/s, en boucle</translation>
    </message>
    <message>
        <source>{}. Nothing is promised of {}.partial: another program has removed, replaced or shortened it</source>
        <translation>{}. Rien n'est garanti de {}.partial : un autre programme l'a supprimé, remplacé ou raccourci</translation>
    </message>
    <message>
        <source>{}. What was written up to {:.1f} s is safe in {}.partial; make it whole with: fyd session recover</source>
        <translation>{}. Ce qui a été écrit jusqu'à {:.1f} s est en sûreté dans {}.partial ; le rendre entier par : fyd session recover</translation>
    </message>
    <message>
        <source>{}: 'body': expected tables [[body]]</source>
        <translation>{} : 'body' : attendu des tables [[body]]</translation>
    </message>
    <message>
        <source>{}: '{}' is not a number; expected {}</source>
        <translation>{} : « {} » n'est pas un nombre ; attendu : {}</translation>
    </message>
    <message>
        <source>{}: '{}' stands outside a table; expected a table such as [control]</source>
        <translation>{} : '{}' est hors d'une table ; attendu une table comme [control]</translation>
    </message>
    <message>
        <source>{}: '{}': expected a table [{}]</source>
        <translation>{} : '{}' : attendu une table [{}]</translation>
    </message>
    <message>
        <source>{}: '{}': expected one of {}</source>
        <translation>{} : '{}' : attendu l'un de {}</translation>
    </message>
    <message>
        <source>{}: [[band]]: expected either wavelength_mm or frequency_Hz</source>
        <translation>{} : [[band]] : attendu soit wavelength_mm, soit frequency_Hz</translation>
    </message>
    <message>
        <source>{}: [{}] without [{}]</source>
        <translation>{} : [{}] sans [{}]</translation>
    </message>
    <message>
        <source>{}: a column without a name</source>
        <translation>{} : une colonne sans nom</translation>
    </message>
    <message>
        <source>{}: a header but no rows</source>
        <translation>{} : un en-tête mais pas de lignes</translation>
    </message>
    <message>
        <source>{}: a later program recorded {}, which a copy by this one would lose; recover it with that program</source>
        <translation>{} : un programme ultérieur a enregistré {}, qu'une copie par celui-ci perdrait ; le récupérer avec ce programme-là</translation>
    </message>
    <message>
        <source>{}: a link to another place; a recording holds its own values</source>
        <translation>{} : un lien vers un autre endroit ; un enregistrement contient ses propres valeurs</translation>
    </message>
    <message>
        <source>{}: a recording is played, nothing is saved: a calibration is made on a touchpad</source>
        <translation>{} : un enregistrement est rejoué, rien n'est enregistré : un étalonnage se fait sur un touchpad</translation>
    </message>
    <message>
        <source>{}: a report ends in .html or .pdf</source>
        <translation>{} : un rapport se termine par .html ou .pdf</translation>
    </message>
    <message>
        <source>{}: a size in it is beyond all reason</source>
        <translation>{} : une taille y est hors de toute mesure</translation>
    </message>
    <message>
        <source>{}: a table has no pictures of which to take the region</source>
        <translation>{} : un tableau n'a pas d'images dont prendre la région</translation>
    </message>
    <message>
        <source>{}: a text of {} bytes</source>
        <translation>{} : un texte de {} octets</translation>
    </message>
    <message>
        <source>{}: a video has no fields to choose</source>
        <translation>{} : une vidéo n'a pas de champs à choisir</translation>
    </message>
    <message>
        <source>{}: already in {}</source>
        <translation>{} : déjà dans {}</translation>
    </message>
    <message>
        <source>{}: an answer to an earlier question was refused; does the touchpad need longer than device.response_timeout_ms = {}?</source>
        <translation>{} : une réponse à une question antérieure a été refusée ; faut-il au touchpad plus que device.response_timeout_ms = {} ?</translation>
    </message>
    <message>
        <source>{}: an export ends in .csv, .mat, .mkv, .avi or .mcap</source>
        <translation>{} : un export se termine par .csv, .mat, .mkv, .avi ou .mcap</translation>
    </message>
    <message>
        <source>{}: an export would end before the recording does; `fyd session recover` makes what can be proven whole first, or export up to an earlier second than {:.3f}</source>
        <translation>{} : un export finirait avant l'enregistrement ; `fyd session recover` rend d'abord entier ce qui peut être prouvé, ou exportez jusqu'à une seconde antérieure à {:.3f}</translation>
    </message>
    <message>
        <source>{}: another recording has this name now; open it again</source>
        <translation>{} : un autre enregistrement porte maintenant ce nom ; le rouvrir</translation>
    </message>
    <message>
        <source>{}: another recording is being started</source>
        <translation>{} : un autre enregistrement est en train de commencer</translation>
    </message>
    <message>
        <source>{}: another touchpad answers: '{}', expected '{}'; plug the right one in, or open a session for this one</source>
        <translation>{} : un autre touchpad répond : '{}', attendu '{}' ; brancher le bon, ou ouvrir une session pour celui-ci</translation>
    </message>
    <message>
        <source>{}: asked for {} Bd, the port runs at {} Bd; choose a speed its driver supports</source>
        <translation>{} : demandé {} Bd, le port fonctionne à {} Bd ; choisir une vitesse que permet son pilote</translation>
    </message>
    <message>
        <source>{}: at most {} values</source>
        <translation>{} : au plus {} valeurs</translation>
    </message>
    <message>
        <source>{}: belongs to another user (uid {}, gid {}), who would lose it; choose another name</source>
        <translation>{} : appartient à un autre utilisateur (uid {}, gid {}), qui le perdrait ; choisissez un autre nom</translation>
    </message>
    <message>
        <source>{}: body.contact: a soft body has its own; expected none beside body.soft</source>
        <translation>{} : body.contact : un corps mou a le sien ; attendu aucun à côté de body.soft</translation>
    </message>
    <message>
        <source>{}: body.kinetic_friction {}: expected at most body.static_friction, {}</source>
        <translation>{} : body.kinetic_friction {} : attendu au plus body.static_friction, {}</translation>
    </message>
    <message>
        <source>{}: body.mesh: expected an OBJ, STL or PLY file</source>
        <translation>{} : body.mesh : attendu un fichier OBJ, STL ou PLY</translation>
    </message>
    <message>
        <source>{}: body.position_mm: expected three numbers</source>
        <translation>{} : body.position_mm : attendu trois nombres</translation>
    </message>
    <message>
        <source>{}: body.turned_deg: expected three numbers</source>
        <translation>{} : body.turned_deg : attendu trois nombres</translation>
    </message>
    <message>
        <source>{}: body.velocity_mm_per_s: expected three numbers</source>
        <translation>{} : body.velocity_mm_per_s : attendu trois nombres</translation>
    </message>
    <message>
        <source>{}: bytes {}+{} of {}</source>
        <translation>{} : octets {}+{} sur {}</translation>
    </message>
    <message>
        <source>{}: calibrated on the simulated touchpad, which a real one does not use: the defaults are used instead ({})</source>
        <translation>{} : étalonné sur le touchpad simulé, ce qu'un vrai n'utilise pas : les valeurs par défaut servent à la place ({})</translation>
    </message>
    <message>
        <source>{}: cannot be deleted: {}</source>
        <translation>{} : ne peut pas être supprimé : {}</translation>
    </message>
    <message>
        <source>{}: cannot be made a link to {}: {}</source>
        <translation>{} : ne peut pas devenir un lien vers {} : {}</translation>
    </message>
    <message>
        <source>{}: cannot be named {}: {}</source>
        <translation>{} : ne peut pas être nommé {} : {}</translation>
    </message>
    <message>
        <source>{}: cannot be opened: {}</source>
        <translation>{} : impossible à ouvrir : {}</translation>
    </message>
    <message>
        <source>{}: cannot be read: it is no file</source>
        <translation>{} : illisible : ce n'est pas un fichier</translation>
    </message>
    <message>
        <source>{}: cannot be read: {}</source>
        <translation>{} : illisible : {}</translation>
    </message>
    <message>
        <source>{}: cannot be set up: {}</source>
        <translation>{} : ne peut pas être réglé : {}</translation>
    </message>
    <message>
        <source>{}: cannot be written</source>
        <translation>{} : ne peut pas être écrit</translation>
    </message>
    <message>
        <source>{}: cannot be written or opened ({}); check the folder's permissions</source>
        <translation>{} : ne peut pas être écrit ou ouvert ({}) ; vérifier les droits du dossier</translation>
    </message>
    <message>
        <source>{}: cannot be written: another program takes its part files away</source>
        <translation>{} : ne peut pas être écrit : un autre programme enlève ses fichiers partiels</translation>
    </message>
    <message>
        <source>{}: cannot be written: {}</source>
        <translation>{} : impossible à écrire : {}</translation>
    </message>
    <message>
        <source>{}: changed while it was copied; is it still being recorded?</source>
        <translation>{} : modifié pendant la copie ; est-il encore en cours d'enregistrement ?</translation>
    </message>
    <message>
        <source>{}: column {} is not of this format's type</source>
        <translation>{} : la colonne {} n'est pas du type de ce format</translation>
    </message>
    <message>
        <source>{}: depth_mm is {}; expected 0 to {}</source>
        <translation>{} : depth_mm vaut {} ; attendu de 0 à {}</translation>
    </message>
    <message>
        <source>{}: does not count the tables' rows</source>
        <translation>{} : ne compte pas les lignes des tables</translation>
    </message>
    <message>
        <source>{}: does not open: {}</source>
        <translation>{} : ne s'ouvre pas : {}</translation>
    </message>
    <message>
        <source>{}: does not open; {}</source>
        <translation>{} : ne s'ouvre pas ; {}</translation>
    </message>
    <message>
        <source>{}: empty; expected a header with {}</source>
        <translation>{} : vide ; attendu un en-tête avec {}</translation>
    </message>
    <message>
        <source>{}: everything needed is there. Arm to start.</source>
        <translation>{} : tout le nécessaire est là. Armer pour commencer.</translation>
    </message>
    <message>
        <source>{}: exists already</source>
        <translation>{} : existe déjà</translation>
    </message>
    <message>
        <source>{}: exists; a recording never replaces a file</source>
        <translation>{} : existe ; un enregistrement ne remplace jamais un fichier</translation>
    </message>
    <message>
        <source>{}: exists; move one of the two away first</source>
        <translation>{} : existe ; déplacer d'abord l'un des deux</translation>
    </message>
    <message>
        <source>{}: expected [[record.{}]]</source>
        <translation>{} : attendu [[record.{}]]</translation>
    </message>
    <message>
        <source>{}: expected a folder</source>
        <translation>{} : attendu un dossier</translation>
    </message>
    <message>
        <source>{}: expected a list of numbers</source>
        <translation>{} : attendue une liste de nombres</translation>
    </message>
    <message>
        <source>{}: expected an ordinary file</source>
        <translation>{} : attendu un fichier ordinaire</translation>
    </message>
    <message>
        <source>{}: expected at least one [[band]]</source>
        <translation>{} : attendu au moins une [[band]]</translation>
    </message>
    <message>
        <source>{}: expected numbers with a point</source>
        <translation>{} : attendus des nombres à point</translation>
    </message>
    <message>
        <source>{}: expected true or false</source>
        <translation>{} : attendu true ou false</translation>
    </message>
    <message>
        <source>{}: expected {}</source>
        <translation>{} : attendu {}</translation>
    </message>
    <message>
        <source>{}: expected {}, in quotes</source>
        <translation>{} : attendu {}, entre guillemets</translation>
    </message>
    <message>
        <source>{}: fewer than two different times: the sample rate is unknown</source>
        <translation>{} : moins de deux temps différents : la fréquence d'échantillonnage est inconnue</translation>
    </message>
    <message>
        <source>{}: format {}; this program reads formats {} to {}</source>
        <translation>{} : format {} ; ce programme lit les formats {} à {}</translation>
    </message>
    <message>
        <source>{}: gives no picture any more</source>
        <translation>{} : ne donne plus d'image</translation>
    </message>
    <message>
        <source>{}: gone while it was read</source>
        <translation>{} : disparu pendant la lecture</translation>
    </message>
    <message>
        <source>{}: has no checksums</source>
        <translation>{} : n'a pas de sommes de contrôle</translation>
    </message>
    <message>
        <source>{}: held-out error {} of at most {:g} mm, falls at every code from {:.0f} to {:.0f}</source>
        <translation>{} : erreur de vérification {} (au plus {:g} mm), décroît à chaque code de {:.0f} à {:.0f}</translation>
    </message>
    <message>
        <source>{}: holds no picture</source>
        <translation>{} : ne contient pas d'image</translation>
    </message>
    <message>
        <source>{}: holds the control character U+{:04X}</source>
        <translation>{} : contient le caractère de commande U+{:04X}</translation>
    </message>
    <message>
        <source>{}: in use by another program ("fuser {}" names it)</source>
        <translation>{} : utilisé par un autre programme (« fuser {} » le nomme)</translation>
    </message>
    <message>
        <source>{}: is a device, not a file</source>
        <translation>{} : c'est un périphérique, pas un fichier</translation>
    </message>
    <message>
        <source>{}: is a folder, not a file</source>
        <translation>{} : c'est un dossier, pas un fichier</translation>
    </message>
    <message>
        <source>{}: is a pipe, not a file</source>
        <translation>{} : c'est un tube, pas un fichier</translation>
    </message>
    <message>
        <source>{}: is a socket, not a file</source>
        <translation>{} : c'est un socket, pas un fichier</translation>
    </message>
    <message>
        <source>{}: is another program's database; expected a catalogue, or a new file</source>
        <translation>{} : est la base de données d'un autre programme ; attendu : un catalogue, ou un nouveau fichier</translation>
    </message>
    <message>
        <source>{}: is being recorded at this moment</source>
        <translation>{} : est en cours d'enregistrement en ce moment</translation>
    </message>
    <message>
        <source>{}: is damaged; `fyd session recover` keeps what can be proven of it first</source>
        <translation>{} : est endommagé ; `fyd session recover` en garde d'abord ce qui peut être prouvé</translation>
    </message>
    <message>
        <source>{}: is no catalogue, and nothing in it shows that it was one; choose another file, or move it away</source>
        <translation>{} : n'est pas un catalogue, et rien n'y montre que c'en était un ; choisir un autre fichier, ou le déplacer</translation>
    </message>
    <message>
        <source>{}: is no serial port</source>
        <translation>{} : n'est pas un port série</translation>
    </message>
    <message>
        <source>{}: is still being recorded; close it first</source>
        <translation>{} : est encore en cours d'enregistrement ; le fermer d'abord</translation>
    </message>
    <message>
        <source>{}: is {} itself under another name, not a copy; nothing was removed</source>
        <translation>{} : est {} lui-même sous un autre nom, pas une copie ; rien n'a été supprimé</translation>
    </message>
    <message>
        <source>{}: it is not the file any more that was written</source>
        <translation>{} : ce n'est plus le fichier qui a été écrit</translation>
    </message>
    <message>
        <source>{}: its calibrations do not tell on which touchpad they were made; they are used with {}</source>
        <translation>{} : ses étalonnages ne disent pas sur quel touchpad ils ont été faits ; ils servent avec : {}</translation>
    </message>
    <message>
        <source>{}: its columns are not those of this format</source>
        <translation>{} : ses colonnes ne sont pas celles de ce format</translation>
    </message>
    <message>
        <source>{}: its links run in a circle</source>
        <translation>{} : ses liens tournent en rond</translation>
    </message>
    <message>
        <source>{}: its mesh is not walkable; expected one for a rigid body</source>
        <translation>{} : son maillage ne peut pas être parcouru ; attendu un pour un corps rigide</translation>
    </message>
    <message>
        <source>{}: its server_encoding is {}; make the database with ENCODING 'UTF8'</source>
        <translation>{} : son server_encoding est {} ; créer la base de données avec ENCODING 'UTF8'</translation>
    </message>
    <message>
        <source>{}: its values lie in other datasets; a recording holds its own</source>
        <translation>{} : ses valeurs sont dans d'autres jeux de données ; un enregistrement contient les siennes</translation>
    </message>
    <message>
        <source>{}: its values lie in other files; a recording holds its own</source>
        <translation>{} : ses valeurs sont dans d'autres fichiers ; un enregistrement contient les siennes</translation>
    </message>
    <message>
        <source>{}: its {} bytes are no picture</source>
        <translation>{} : ses {} octets ne sont pas une image</translation>
    </message>
    <message>
        <source>{}: its {} bytes are no picture as the recorder writes it</source>
        <translation>{} : ses {} octets ne sont pas une image telle que l'écrit l'enregistreur</translation>
    </message>
    <message>
        <source>{}: lies on {}; a recording needs a local disk, whose promise to have written can be trusted</source>
        <translation>{} : est sur {} ; un enregistrement a besoin d'un disque local, dont la promesse d'avoir écrit est fiable</translation>
    </message>
    <message>
        <source>{}: locked by another program for more than {} s; it is open in {}</source>
        <translation>{} : verrouillé par un autre programme depuis plus de {} s ; il est ouvert dans {}</translation>
    </message>
    <message>
        <source>{}: made by a newer version of this program (tables {}, this one knows {})</source>
        <translation>{} : fait par une version plus récente de ce programme (tables {}, celui-ci connaît {})</translation>
    </message>
    <message>
        <source>{}: mend that, then arm again</source>
        <translation>{} : y remédier, puis armer de nouveau</translation>
    </message>
    <message>
        <source>{}: name of {} bytes: expected 1 to {} that can be printed</source>
        <translation>{} : name de {} octets : de 1 à {} imprimables attendus</translation>
    </message>
    <message>
        <source>{}: no 'format'; expected a record of calibrations, format = {}</source>
        <translation>{} : pas de 'format' ; attendu un registre d'étalonnages, format = {}</translation>
    </message>
    <message>
        <source>{}: no line --- between the card's head and its rows; expected one</source>
        <translation>{} : aucune ligne --- entre l'en-tête de la carte et ses lignes ; une attendue</translation>
    </message>
    <message>
        <source>{}: no memory for its variables</source>
        <translation>{} : pas de mémoire pour ses variables</translation>
    </message>
    <message>
        <source>{}: no mesh by its name; expected .obj, .stl or .ply</source>
        <translation>{} : d'après son nom, pas un maillage ; attendu .obj, .stl ou .ply</translation>
    </message>
    <message>
        <source>{}: no mesh; expected one</source>
        <translation>{} : aucun maillage ; attendu un</translation>
    </message>
    <message>
        <source>{}: no permission. Add yourself to its group with "sudo usermod -aG {} $USER" and log in again</source>
        <translation>{} : pas de permission. S'ajouter à son groupe par « sudo usermod -aG {} $USER » et se reconnecter</translation>
    </message>
    <message>
        <source>{}: no picture can be made</source>
        <translation>{} : aucune image ne peut être faite</translation>
    </message>
    <message>
        <source>{}: no picture of this format can be made</source>
        <translation>{} : aucune image de ce format ne peut être faite</translation>
    </message>
    <message>
        <source>{}: no pseudo-terminal to be had: {}</source>
        <translation>{} : pas de pseudo-terminal disponible : {}</translation>
    </message>
    <message>
        <source>{}: no such parameter</source>
        <translation>{} : ce paramètre n'existe pas</translation>
    </message>
    <message>
        <source>{}: no such parameter in this profile</source>
        <translation>{} : pas de paramètre de ce nom dans ce profil</translation>
    </message>
    <message>
        <source>{}: no temporary file can be made: {}</source>
        <translation>{} : aucun fichier temporaire ne peut être créé : {}</translation>
    </message>
    <message>
        <source>{}: no {}; expected "{}" and {} words</source>
        <translation>{} : pas de {} ; attendu « {} » et {} mots</translation>
    </message>
    <message>
        <source>{}: no {}; expected {}</source>
        <translation>{} : {} manque ; attendu {}</translation>
    </message>
    <message>
        <source>{}: not UTF-8</source>
        <translation>{} : pas de l'UTF-8</translation>
    </message>
    <message>
        <source>{}: not a dataset</source>
        <translation>{} : pas un jeu de données</translation>
    </message>
    <message>
        <source>{}: not a file's name</source>
        <translation>{} : n'est pas un nom de fichier</translation>
    </message>
    <message>
        <source>{}: not a folder</source>
        <translation>{} : pas un dossier</translation>
    </message>
    <message>
        <source>{}: not a group as a recording has it</source>
        <translation>{} : pas un groupe tel qu'en a un enregistrement</translation>
    </message>
    <message>
        <source>{}: not a list of rows</source>
        <translation>{} : pas une liste de lignes</translation>
    </message>
    <message>
        <source>{}: not a text</source>
        <translation>{} : pas un texte</translation>
    </message>
    <message>
        <source>{}: not a touchpad: its first registers say 0x{:08X}, expected 0x{:08X}</source>
        <translation>{} : pas un touchpad : ses premiers registres disent 0x{:08X}, attendu 0x{:08X}</translation>
    </message>
    <message>
        <source>{}: not all of it could be written; is the disk full?</source>
        <translation>{} : tout n'a pas pu être écrit ; le disque est-il plein ?</translation>
    </message>
    <message>
        <source>{}: not bytes</source>
        <translation>{} : pas des octets</translation>
    </message>
    <message>
        <source>{}: not in chunks of {} rows{}, as this program stores it: another program packed it anew</source>
        <translation>{} : pas en blocs de {} lignes{}, comme ce programme les range : un autre programme l'a recompressé</translation>
    </message>
    <message>
        <source>{}: not in one piece</source>
        <translation>{} : pas d'un seul tenant</translation>
    </message>
    <message>
        <source>{}: not kept, nothing is being recorded</source>
        <translation>{} : pas conservé, rien n'est en cours d'enregistrement</translation>
    </message>
    <message>
        <source>{}: not kept, the session is closed</source>
        <translation>{} : pas conservé, la session est fermée</translation>
    </message>
    <message>
        <source>{}: not one number</source>
        <translation>{} : pas un seul nombre</translation>
    </message>
    <message>
        <source>{}: not one text</source>
        <translation>{} : pas un seul texte</translation>
    </message>
    <message>
        <source>{}: not open</source>
        <translation>{} : non ouvert</translation>
    </message>
    <message>
        <source>{}: not read to its end: the program was asked to end</source>
        <translation>{} : pas lu jusqu'à la fin : il a été demandé au programme de se terminer</translation>
    </message>
    <message>
        <source>{}: note {}: {}</source>
        <translation>{} : note {} : {}</translation>
    </message>
    <message>
        <source>{}: notes of another recording of this name; move them away, or choose another name</source>
        <translation>{} : notes d'un autre enregistrement de ce nom ; les déplacer, ou choisir un autre nom</translation>
    </message>
    <message>
        <source>{}: nothing more can be recorded: {}</source>
        <translation>{} : rien de plus ne peut être enregistré : {}</translation>
    </message>
    <message>
        <source>{}: nothing to touch; expected a [[body]], [swords], [ball] or [palpation]</source>
        <translation>{} : rien à toucher ; attendu un [[body]], [swords], [ball] ou [palpation]</translation>
    </message>
    <message>
        <source>{}: on a network share, where SQLite would be damaged; use a local path, or postgresql:…</source>
        <translation>{} : sur un partage réseau, où SQLite serait endommagé ; utiliser un chemin local, ou postgresql:…</translation>
    </message>
    <message>
        <source>{}: only notes and bookmarks are written here</source>
        <translation>{} : seuls des notes et des signets s'écrivent ici</translation>
    </message>
    <message>
        <source>{}: out of memory</source>
        <translation>{} : plus de mémoire</translation>
    </message>
    <message>
        <source>{}: picture {} was not kept</source>
        <translation>{} : l'image {} n'a pas été gardée</translation>
    </message>
    <message>
        <source>{}: plane.normal_x, normal_y and normal_z are 0: expected a direction</source>
        <translation>{} : plane.normal_x, normal_y et normal_z sont 0 : attendu une direction</translation>
    </message>
    <message>
        <source>{}: pseudo-terminal: {}</source>
        <translation>{} : pseudo-terminal : {}</translation>
    </message>
    <message>
        <source>{}: reads differently each time; copy it to another disk first</source>
        <translation>{} : chaque lecture donne autre chose ; copiez-le d'abord sur un autre disque</translation>
    </message>
    <message>
        <source>{}: refused, nothing is saved: {}</source>
        <translation>{} : refusée, rien n'est enregistré : {}</translation>
    </message>
    <message>
        <source>{}: register map {}.{}, this program knows {}.x; update the older of the two</source>
        <translation>{} : table des registres {}.{}, ce programme connaît la {}.x ; mettre à jour le plus ancien des deux</translation>
    </message>
    <message>
        <source>{}: rendering.</source>
        <translation>{} : rendu en cours.</translation>
    </message>
    <message>
        <source>{}: room for other rows than asked</source>
        <translation>{} : place pour un autre nombre de lignes que demandé</translation>
    </message>
    <message>
        <source>{}: row {} has a list that counts more than it can hold</source>
        <translation>{} : la ligne {} a une liste qui compte plus qu'elle ne peut contenir</translation>
    </message>
    <message>
        <source>{}: row {} of {}</source>
        <translation>{} : ligne {} sur {}</translation>
    </message>
    <message>
        <source>{}: row {} says that its text begins at byte {}; expected {} or more, behind the text before it</source>
        <translation>{} : la ligne {} dit que son texte commence à l'octet {} ; attendu {} ou plus, derrière le texte qui précède</translation>
    </message>
    <message>
        <source>{}: rows from {} on are packed otherwise</source>
        <translation>{} : les lignes à partir de {} sont compressées autrement</translation>
    </message>
    <message>
        <source>{}: rows from {} on take {} bytes</source>
        <translation>{} : les lignes à partir de {} prennent {} octets</translation>
    </message>
    <message>
        <source>{}: rows from {} on: {}</source>
        <translation>{} : lignes à partir de {} : {}</translation>
    </message>
    <message>
        <source>{}: rows of {} bytes; this program's have {}</source>
        <translation>{} : lignes de {} octets ; celles de ce programme en ont {}</translation>
    </message>
    <message>
        <source>{}: rows {} to {} are damaged: CRC32C {:08x}, committed as {:08x}</source>
        <translation>{} : les lignes {} à {} sont endommagées : CRC32C {:08x}, validées comme {:08x}</translation>
    </message>
    <message>
        <source>{}: rows {} to {} in one block</source>
        <translation>{} : lignes {} à {} dans un bloc</translation>
    </message>
    <message>
        <source>{}: rows {}+{} of {}</source>
        <translation>{} : lignes {}+{} sur {}</translation>
    </message>
    <message>
        <source>{}: saved values are felt now; go back to the current ones to change it</source>
        <translation>{} : les valeurs enregistrées sont ressenties ; revenir aux actuelles pour le changer</translation>
    </message>
    <message>
        <source>{}: says to be {} bytes, while {} stand in the file of {} bytes</source>
        <translation>{} : dit faire {} octets, alors que {} se trouvent dans le fichier de {} octets</translation>
    </message>
    <message>
        <source>{}: scene.accuracy "{}": expected a share such as "1%", above 0 and up to 100%</source>
        <translation>{} : scene.accuracy "{}" : attendu une part comme "1%", au-dessus de 0 et jusqu'à 100%</translation>
    </message>
    <message>
        <source>{}: sends damaged pictures: {}</source>
        <translation>{} : envoie des images endommagées : {}</translation>
    </message>
    <message>
        <source>{}: sensors are live, motors are off.</source>
        <translation>{} : capteurs actifs, moteurs coupés.</translation>
    </message>
    <message>
        <source>{}: set it to remote, and close what else drives it</source>
        <translation>{} : le mettre en commande à distance et fermer ce qui le pilote par ailleurs</translation>
    </message>
    <message>
        <source>{}: simulated points, nothing is saved: these values would be used by {}</source>
        <translation>{} : points simulés, rien n'est enregistré : ces valeurs serviraient à : {}</translation>
    </message>
    <message>
        <source>{}: source of {} bytes: expected at most {} that can be printed</source>
        <translation>{} : source de {} octets : au plus {} imprimables attendus</translation>
    </message>
    <message>
        <source>{}: speed = {}: expected {} to {}</source>
        <translation>{} : speed = {} : attendu de {} à {}</translation>
    </message>
    <message>
        <source>{}: stored, but the source cannot be removed: {}; it is whole in both places</source>
        <translation>{} : archivé, mais la source ne peut pas être supprimée : {} ; il est entier aux deux endroits</translation>
    </message>
    <message>
        <source>{}: t_s is {} after {}; time must increase from row to row</source>
        <translation>{} : t_s vaut {} après {} ; le temps doit croître de ligne en ligne</translation>
    </message>
    <message>
        <source>{}: t_s is {}; expected 0 in the first row</source>
        <translation>{} : t_s vaut {} ; 0 attendu dans la première ligne</translation>
    </message>
    <message>
        <source>{}: t_s is {}; expected 0 to {} s</source>
        <translation>{} : t_s vaut {} ; attendu de 0 à {} s</translation>
    </message>
    <message>
        <source>{}: take points at the cloth's corners, far from its middle, some on the untouched cloth and some pressed down as deep as you can</source>
        <translation>{} : prendre des points aux coins du tissu, loin de son milieu, certains sur le tissu non touché et certains enfoncés aussi profond que possible</translation>
    </message>
    <message>
        <source>{}: the CSV parser could not start</source>
        <translation>{} : le lecteur CSV n'a pas pu démarrer</translation>
    </message>
    <message>
        <source>{}: the catalogue is damaged ({}); the recordings are not touched by that. `fyd session list --rebuild FOLDER{}` moves the file aside and reads the recordings again</source>
        <translation>{} : le catalogue est endommagé ({}) ; les enregistrements n'en sont pas touchés. `fyd session list --rebuild FOLDER{}` met le fichier de côté et relit les enregistrements</translation>
    </message>
    <message>
        <source>{}: the copy cannot get its name: {}</source>
        <translation>{} : la copie ne peut pas recevoir son nom : {}</translation>
    </message>
    <message>
        <source>{}: the copy reads back differently from the source; the storage is not to be trusted</source>
        <translation>{} : la copie relue diffère de la source ; ce stockage n'est pas fiable</translation>
    </message>
    <message>
        <source>{}: the device behind the port is gone; is the cable plugged in?</source>
        <translation>{} : l'appareil derrière le port a disparu ; le câble est-il branché ?</translation>
    </message>
    <message>
        <source>{}: the disk does not answer; a file that it still makes is closed at once</source>
        <translation>{} : le disque ne répond pas ; un fichier qu'il crée encore est fermé aussitôt</translation>
    </message>
    <message>
        <source>{}: the disk does not answer; the file is closed when it does</source>
        <translation>{} : le disque ne répond pas ; le fichier sera fermé quand il répondra</translation>
    </message>
    <message>
        <source>{}: the disk has {:.0f} MB left, fewer than the {:.0f} MB a recording leaves free</source>
        <translation>{} : il reste {:.0f} Mo sur le disque, moins que les {:.0f} Mo qu'un enregistrement laisse libres</translation>
    </message>
    <message>
        <source>{}: the disk is full; nothing of this change was kept</source>
        <translation>{} : le disque est plein ; rien de cette modification n'a été gardé</translation>
    </message>
    <message>
        <source>{}: the entry {} is damaged: {}</source>
        <translation>{} : l'entrée {} est endommagée : {}</translation>
    </message>
    <message>
        <source>{}: the folder cannot be made: {}</source>
        <translation>{} : le dossier ne peut pas être créé : {}</translation>
    </message>
    <message>
        <source>{}: the folder cannot be used: {}</source>
        <translation>{} : dossier inutilisable : {}</translation>
    </message>
    <message>
        <source>{}: the picture could not be made</source>
        <translation>{} : l'image n'a pas pu être faite</translation>
    </message>
    <message>
        <source>{}: the pseudo-terminal has no name</source>
        <translation>{} : le pseudo-terminal n'a pas de nom</translation>
    </message>
    <message>
        <source>{}: the recorder is not running</source>
        <translation>{} : l'enregistreur ne fonctionne pas</translation>
    </message>
    <message>
        <source>{}: the recording has ended</source>
        <translation>{} : l'enregistrement est terminé</translation>
    </message>
    <message>
        <source>{}: the recording holds no picture</source>
        <translation>{} : l'enregistrement ne contient pas d'image</translation>
    </message>
    <message>
        <source>{}: the recording holds no step</source>
        <translation>{} : l'enregistrement ne contient aucun pas</translation>
    </message>
    <message>
        <source>{}: the recording shows no picture for another {:.1f} s</source>
        <translation>{} : l'enregistrement ne montre pas d'image pendant encore {:.1f} s</translation>
    </message>
    <message>
        <source>{}: the session is closed</source>
        <translation>{} : la session est fermée</translation>
    </message>
    <message>
        <source>{}: the touchpad does not answer.</source>
        <translation>{} : le touchpad ne répond pas.</translation>
    </message>
    <message>
        <source>{}: there is a file of this name already</source>
        <translation>{} : il y a déjà un fichier de ce nom</translation>
    </message>
    <message>
        <source>{}: there is another file of this name; nothing was moved</source>
        <translation>{} : il y a un autre fichier de ce nom ; rien n'a été déplacé</translation>
    </message>
    <message>
        <source>{}: there is no such file</source>
        <translation>{} : ce fichier n'existe pas</translation>
    </message>
    <message>
        <source>{}: there is no such port; is the cable plugged in?</source>
        <translation>{} : ce port n'existe pas ; le câble est-il branché ?</translation>
    </message>
    <message>
        <source>{}: these notes are of another recording, {}; expected {}</source>
        <translation>{} : ces notes sont celles d'un autre enregistrement, {} ; attendu {}</translation>
    </message>
    <message>
        <source>{}: too many changes at once</source>
        <translation>{} : trop de changements à la fois</translation>
    </message>
    <message>
        <source>{}: too many of this name; move them away</source>
        <translation>{} : trop de fichiers de ce nom ; les déplacer</translation>
    </message>
    <message>
        <source>{}: unknown key '{}' in {}</source>
        <translation>{} : clé inconnue '{}' dans {}</translation>
    </message>
    <message>
        <source>{}: unknown parameter '{}'; '{}' lists those there are</source>
        <translation>{} : paramètre inconnu '{}' ; '{}' donne la liste de ceux qui existent</translation>
    </message>
    <message>
        <source>{}: was left behind by a crash; `fyd session recover` makes it whole first</source>
        <translation>{} : laissé par un arrêt brutal ; `fyd session recover` le rend d'abord entier</translation>
    </message>
    <message>
        <source>{}: what waits for catalogues is damaged ({}); the recordings are not touched by that. Move the file away, then `fyd session list --rebuild FOLDER` for each catalogue reads the recordings again</source>
        <translation>{} : ce qui attend les catalogues est endommagé ({}) ; les enregistrements n'en sont pas touchés. Déplacer le fichier, puis `fyd session list --rebuild FOLDER` pour chaque catalogue relit les enregistrements</translation>
    </message>
    <message>
        <source>{}: without a column t_s the sample rate must be given</source>
        <translation>{} : sans colonne t_s, la fréquence d'échantillonnage doit être donnée</translation>
    </message>
    <message>
        <source>{}: writing failed: {}</source>
        <translation>{} : échec de l'écriture : {}</translation>
    </message>
    <message>
        <source>{}: writing failed: {}; nothing is left of it</source>
        <translation>{} : l'écriture a échoué : {} ; il n'en reste rien</translation>
    </message>
    <message>
        <source>{}: writing failed: {}; the file stays as it was</source>
        <translation>{} : l'écriture a échoué : {} ; le fichier reste tel quel</translation>
    </message>
    <message>
        <source>{}: writing {} failed; is the disk full?</source>
        <translation>{} : l'écriture de {} a échoué ; le disque est-il plein ?</translation>
    </message>
    <message>
        <source>{}: x_mm is {}; expected −{} to {}</source>
        <translation>{} : x_mm vaut {} ; attendu de −{} à {}</translation>
    </message>
    <message>
        <source>{}: y_mm is {}; expected −{} to {}</source>
        <translation>{} : y_mm vaut {} ; attendu de −{} à {}</translation>
    </message>
    <message>
        <source>{}: {:.0f} % of the acceleration held out is left; breakaway {:.1f} ± {:.1f} % and {:.1f} ± {:.1f} %, resonance {:.1f} ± {:.1f} Hz at {:.0f}°, damping {:.2f}</source>
        <translation>{} : il reste {:.0f} % de l'accélération mise de côté ; décollage {:.1f} ± {:.1f} % et {:.1f} ± {:.1f} %, résonance {:.1f} ± {:.1f} Hz à {:.0f}°, amortissement {:.2f}</translation>
    </message>
    <message>
        <source>{}: {:.1f} MB free, the recording needs {:.1f} MB</source>
        <translation>{} : {:.1f} Mo libres, l'enregistrement a besoin de {:.1f} Mo</translation>
    </message>
    <message>
        <source>{}: {} Bd is no speed of this system</source>
        <translation>{} : {} Bd n'est pas une vitesse de ce système</translation>
    </message>
    <message>
        <source>{}: {} Bd is no speed of this system; expected one of {}</source>
        <translation>{} : {} Bd n'est pas une vitesse de ce système ; attendu l'une de {}</translation>
    </message>
    <message>
        <source>{}: {} IR sensors and {} motors, expected {} and {}</source>
        <translation>{} : {} capteurs IR et {} moteurs, attendu {} et {}</translation>
    </message>
    <message>
        <source>{}: {} at register {}: {}</source>
        <translation>{} : {} au registre {} : {}</translation>
    </message>
    <message>
        <source>{}: {} bands; at most {}</source>
        <translation>{} : {} bandes ; au plus {}</translation>
    </message>
    <message>
        <source>{}: {} bodies; at most {}</source>
        <translation>{} : {} corps ; au plus {}</translation>
    </message>
    <message>
        <source>{}: {} bytes</source>
        <translation>{} : {} octets</translation>
    </message>
    <message>
        <source>{}: {} bytes long, at most {} are catalogued</source>
        <translation>{} : long de {} octets, au plus {} sont catalogués</translation>
    </message>
    <message>
        <source>{}: {} bytes with control characters; expected {}</source>
        <translation>{} : {} octets avec des caractères de commande ; attendu {}</translation>
    </message>
    <message>
        <source>{}: {} bytes, expected at most {}</source>
        <translation>{} : {} octets, au plus {} attendus</translation>
    </message>
    <message>
        <source>{}: {} bytes; expected {}</source>
        <translation>{} : {} octets ; attendu {}</translation>
    </message>
    <message>
        <source>{}: {} cannot change while the station runs; a preset holds live parameters only</source>
        <translation>{} : {} ne peut pas changer pendant que la station tourne ; un préréglage ne contient que des paramètres modifiables en marche</translation>
    </message>
    <message>
        <source>{}: {} follows {}; expected rising values</source>
        <translation>{} : {} suit {} ; attendu des valeurs croissantes</translation>
    </message>
    <message>
        <source>{}: {} in one step</source>
        <translation>{} : {} en un pas</translation>
    </message>
    <message>
        <source>{}: {} is no calibrated value, nothing is saved</source>
        <translation>{} : {} n'est pas une valeur étalonnée, rien n'est enregistré</translation>
    </message>
    <message>
        <source>{}: {} is no folder</source>
        <translation>{} : {} n'est pas un dossier</translation>
    </message>
    <message>
        <source>{}: {} is still being recorded; stop it first</source>
        <translation>{} : {} est encore en cours d'enregistrement ; l'arrêter d'abord</translation>
    </message>
    <message>
        <source>{}: {} rows a second; expected {} and more: are the times in seconds?</source>
        <translation>{} : {} lignes par seconde ; {} ou plus attendues : les temps sont-ils en secondes ?</translation>
    </message>
    <message>
        <source>{}: {} rows of {} bytes each, while the whole file takes {} bytes</source>
        <translation>{} : {} lignes de {} octets chacune, alors que le fichier entier prend {} octets</translation>
    </message>
    <message>
        <source>{}: {} rows of {} fields are {:.1f} GiB, a MATLAB 5 file takes 2; choose fewer fields or a shorter time</source>
        <translation>{} : {} lignes de {} champs font {:.1f} Gio, un fichier MATLAB 5 en prend 2 ; choisir moins de champs ou un temps plus court</translation>
    </message>
    <message>
        <source>{}: {} rows: expected two and more</source>
        <translation>{} : {} lignes : deux ou plus attendues</translation>
    </message>
    <message>
        <source>{}: {} values; expected at most {}</source>
        <translation>{} : {} valeurs ; attendu au plus {}</translation>
    </message>
    <message>
        <source>{}: {} with {} values: expected one number, or one for each of {} motors</source>
        <translation>{} : {} avec {} valeurs : attendu un nombre, ou un pour chacun des {} moteurs</translation>
    </message>
    <message>
        <source>{}: {} without '{}'</source>
        <translation>{} : {} sans '{}'</translation>
    </message>
    <message>
        <source>{}: {} × {} pixels; at most {} are read</source>
        <translation>{} : {} × {} pixels ; au plus {} sont lus</translation>
    </message>
    <message>
        <source>{}: {}, {} times in a row</source>
        <translation>{} : {}, {} fois de suite</translation>
    </message>
    <message>
        <source>{}: {}. {} Then re-arm.</source>
        <translation>{} : {}. {} Puis réarmer.</translation>
    </message>
    <message>
        <source>{}: {}: expected a text in quotes</source>
        <translation>{} : {} : attendu un texte entre guillemets</translation>
    </message>
    <message>
        <source>{}: {}: expected true or false</source>
        <translation>{} : {} : attendu true ou false</translation>
    </message>
    <message>
        <source>{}: {}; the recording stays at {}</source>
        <translation>{} : {} ; l'enregistrement reste à {}</translation>
    </message>
    <message>
        <source>{}: {}; {}. Then re-arm.</source>
        <translation>{} : {} ; {}. Puis réarmer.</translation>
    </message>
    <message>
        <source>{}: {}{}: expected a number from {} to {}</source>
        <translation>{} : {}{} : attendu un nombre de {} à {}</translation>
    </message>
    <message>
        <source>{}: {}{}: expected {}</source>
        <translation>{} : {}{} : attendu {}</translation>
    </message>
    <message>
        <source>{}:1: format = "{}": expected "{}"</source>
        <translation>{}:1 : format = "{}" : "{}" attendu</translation>
    </message>
    <message>
        <source>{}:{}: a key of more than {} parts; expected a table and a name</source>
        <translation>{}:{} : une clé de plus de {} parties ; attendu une table et un nom</translation>
    </message>
    <message>
        <source>{}:{}: column '{}' stands there more than once; expected each name once</source>
        <translation>{}:{} : la colonne '{}' s'y trouve plus d'une fois ; attendu chaque nom une fois</translation>
    </message>
    <message>
        <source>{}:{}: column {}: '{}' is not a number</source>
        <translation>{}:{} : colonne {} : '{}' n'est pas un nombre</translation>
    </message>
    <message>
        <source>{}:{}: delay {} ms: expected 0 to 60000, or nan for a loss</source>
        <translation>{}:{} : retard {} ms : attendu de 0 à 60000, ou nan pour une perte</translation>
    </message>
    <message>
        <source>{}:{}: more than {} columns; expected a table of measurements</source>
        <translation>{}:{} : plus de {} colonnes ; attendu : un tableau de mesures</translation>
    </message>
    <message>
        <source>{}:{}: no column '{}'; expected {}</source>
        <translation>{}:{} : pas de colonne '{}' ; attendu {}</translation>
    </message>
    <message>
        <source>{}:{}: not valid CSV: {}</source>
        <translation>{}:{} : CSV non valable : {}</translation>
    </message>
    <message>
        <source>{}:{}: t_s = {} after {}: expected times that do not go backwards</source>
        <translation>{}:{} : t_s = {} après {} : attendu des temps qui ne reculent pas</translation>
    </message>
    <message>
        <source>{}:{}: t_s = {}: expected a finite time in seconds</source>
        <translation>{}:{} : t_s = {} : attendu un temps fini en secondes</translation>
    </message>
    <message>
        <source>{}:{}: t_s is {} after {}; time must increase from row to row</source>
        <translation>{}:{} : t_s vaut {} après {} ; le temps doit croître de ligne en ligne</translation>
    </message>
    <message>
        <source>{}:{}: t_s is {}; expected a time in seconds</source>
        <translation>{}:{} : t_s vaut {} ; attendu un temps en secondes</translation>
    </message>
    <message>
        <source>{}:{}: time {} s: expected times that start at 0 and rise</source>
        <translation>{}:{} : temps {} s : attendu des temps qui commencent à 0 et croissent</translation>
    </message>
    <message>
        <source>{}:{}: {} = {}: expected a number from {} to {}</source>
        <translation>{}:{} : {} = {} : attendu un nombre de {} à {}</translation>
    </message>
    <message>
        <source>{}:{}: {} fields; the header has {}</source>
        <translation>{}:{} : {} champs ; l'en-tête en a {}</translation>
    </message>
    <message>
        <source>{}:{}: {} is {}; expected millimetres within ±{}</source>
        <translation>{}:{} : {} vaut {} ; attendu des millimètres à ±{} près</translation>
    </message>
    <message>
        <source>{}:{}: {} ms after the row before; expected a row each millisecond</source>
        <translation>{}:{} : {} ms après la ligne précédente ; attendu une ligne par milliseconde</translation>
    </message>
    <message>
        <source>{}:{}: {} of x_mm, y_mm, z_mm are NaN; all three mean a lifted finger, otherwise none may be</source>
        <translation>{}:{} : {} parmi x_mm, y_mm, z_mm sont NaN ; tous les trois veulent dire un doigt levé, sinon aucun ne peut l'être</translation>
    </message>
    <message>
        <source>{}:{}: {}: expected one of {}</source>
        <translation>{}:{} : {} : un parmi {} attendu</translation>
    </message>
    <message>
        <source>{}:{}: {}: expected {}</source>
        <translation>{}:{} : {} : attendu {}</translation>
    </message>
    <message>
        <source>{}; WARNING: {}</source>
        <translation>{} ; ATTENTION : {}</translation>
    </message>
    <message>
        <source>{}; make what can be proven whole with: fyd session recover</source>
        <translation>{} ; rendre entier ce qui peut être prouvé par : fyd session recover</translation>
    </message>
    <message>
        <source>{}; nor can the entry wait: {}. The recording is safe; put it in later with `fyd session add {}`</source>
        <translation>{} ; et l'entrée ne peut pas attendre non plus : {}. L'enregistrement est en sûreté ; l'ajouter plus tard par `fyd session add {}`</translation>
    </message>
    <message>
        <source>{}; of {} and {}, move away the notes that are not needed</source>
        <translation>{} ; de {} et {}, déplacer ailleurs les notes dont on n'a pas besoin</translation>
    </message>
    <message>
        <source>{}; the damaged catalogue is {} now</source>
        <translation>{} ; le catalogue endommagé est maintenant {}</translation>
    </message>
    <message>
        <source>{}; the entry waits in {} and goes in when the catalogue is next opened</source>
        <translation>{} ; l'entrée attend dans {} et y entrera à la prochaine ouverture du catalogue</translation>
    </message>
    <message>
        <source>{}; the former devices could not be had again either: {}</source>
        <translation>{} ; les appareils précédents n’ont pas pu être repris non plus : {}</translation>
    </message>
    <message>
        <source>{}; the former session could not be had again either: {}</source>
        <translation>{} ; la session précédente n'a pas pu être reprise non plus : {}</translation>
    </message>
    <message>
        <source>{}; the recording is whole in both places, {} and {}: store it again to finish</source>
        <translation>{} ; l'enregistrement est entier aux deux endroits, {} et {} : l'archiver de nouveau pour terminer</translation>
    </message>
    <message>
        <source>{}; the recording stays at {}</source>
        <translation>{} ; l'enregistrement reste à {}</translation>
    </message>
    <message>
        <source>{}; {} is whole up to here. Make room or choose another disk</source>
        <translation>{} ; {} est intact jusqu'ici. Faire de la place ou choisir un autre disque</translation>
    </message>
    <message>
        <source>{}{}: cannot be renamed to {}: {}</source>
        <translation>{}{} : ne peut pas être renommé en {} : {}</translation>
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
        <translation>• Enregistrer le profil</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
</context>
</TS>
