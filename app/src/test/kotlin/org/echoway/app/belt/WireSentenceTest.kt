package org.echoway.app.belt

import org.junit.Assert.assertEquals
import org.junit.Test

class WireSentenceTest {
    @Test fun checksumIsTheOneOfTheStandard() {
        // The check value that catalogues of CRCs give for CRC-16/CCITT-FALSE.
        assertEquals(0x29B1, WireSentence.crc("123456789".toByteArray()))
    }

    @Test fun rangeIsInMillimetresBetweenDollarAndLineEnd() {
        val sentence = WireSentence.range(65_537, 3, 1.2345).decodeToString()
        assertEquals("\$EWR,1,3,1235*", sentence.dropLast(6))
        assertEquals("\r\n", sentence.takeLast(2))
    }

    @Test fun noEchoIsAnEmptyField() {
        assertEquals("\$EWR,0,14,", WireSentence.range(0, 14, null).decodeToString().substringBefore('*'))
    }
}
