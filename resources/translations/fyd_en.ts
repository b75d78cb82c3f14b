<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>FYD</name>
    <message numerus="yes">
        <source>%n sample(s) lost</source>
        <translation><numerusform>%n sample lost</numerusform><numerusform>%n samples lost</numerusform></translation>
    </message>
</context>
</TS>
