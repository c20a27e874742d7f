package org.echoway.app.belt

import java.util.Locale
import kotlin.math.roundToInt

/** Sentences of the belt's wire protocol, as a belt that computes distance itself would send them. */
object WireSentence {
    private const val POLYNOMIAL = 0x1021
    private const val SEQUENCE_MODULUS = 65536

    /** One firing; [rangeM] is null when nothing answered. */
    fun range(sequence: Int, sensor: Int, rangeM: Double?): ByteArray {
        val millimetres = rangeM?.let { (it * 1000).roundToInt().toString() }.orEmpty()
        return sentence("EWR,${sequence % SEQUENCE_MODULUS},$sensor,$millimetres")
    }

    /** The belt's status, with neither temperature nor battery. */
    fun status(sensors: Int, firmware: String): ByteArray = sentence("EWS,$sensors,$firmware,,")

    internal fun sentence(body: String): ByteArray {
        val bytes = body.toByteArray(Charsets.US_ASCII)
        return "$$body*%04X\r\n".format(Locale.ROOT, crc(bytes)).toByteArray(Charsets.US_ASCII)
    }

    /** CRC-16/CCITT-FALSE. */
    internal fun crc(bytes: ByteArray): Int = bytes.fold(0xFFFF) { crc, byte ->
        (0 until 8).fold(crc xor ((byte.toInt() and 0xFF) shl 8)) { c, _ ->
            (if (c and 0x8000 != 0) (c shl 1) xor POLYNOMIAL else c shl 1) and 0xFFFF
        }
    }
}
