package org.echoway.bench

import com.sun.management.ThreadMXBean
import java.io.File
import java.lang.management.ManagementFactory
import org.echoway.app.belt.WalkLog
import org.echoway.app.belt.WireSentence
import org.echoway.core.CoreSession
import org.echoway.core.Estimate
import org.echoway.core.PlanLoader
import org.echoway.core.Start

/**
 * From the last byte of a sentence to the new estimate in Kotlin, on the walk that comes with the app. What the
 * crossing itself costs is measured with bytes that complete no sentence, so that the core has nothing to do.
 */
fun main(arguments: Array<String>) {
    val root = File(arguments[0])
    val building = File(root, "maps/torgersen-lab")
    val log = File(root, "app/src/main/assets/walks/torgersen-lab.scans.csv").bufferedReader().use { WalkLog.read(it) }
    val sentences =
        log.firings.mapIndexed { i, firing -> firing.timeS to WireSentence.range(i, firing.sensor, firing.rangeM) }
    val room = PlanLoader.load(building).rooms.indexOfFirst { it.id == "1" }

    repeat(WARM_UP) { walk(building, room, sentences) }
    report("sentence to estimate", List(RUNS) { walk(building, room, sentences) }.flatten())
    val nothing = sentences.map { it.first to byteArrayOf('x'.code.toByte()) }
    repeat(WARM_UP * 20) { walk(building, room, nothing) }
    report("crossing alone", List(RUNS * 20) { walk(building, room, nothing) }.flatten())
    CoreSession.open(building, 0.0, Start(room)).use { session ->
        val threads = ManagementFactory.getThreadMXBean() as ThreadMXBean
        val before = threads.currentThreadAllocatedBytes
        for ((timeS, bytes) in sentences) session.onBytes(bytes, timeS)
        println(
            "allocated by feeding: %.1f bytes a firing".format(
                (threads.currentThreadAllocatedBytes - before).toDouble() / sentences.size,
            ),
        )
    }
}

private const val WARM_UP = 3
private const val RUNS = 5

@Volatile private var newest: Estimate? = null

private fun walk(building: File, room: Int, sentences: List<Pair<Double, ByteArray>>): List<Long> =
    CoreSession.open(building, 0.0, Start(room)).use { session ->
        sentences.map { (timeS, bytes) ->
            val start = System.nanoTime()
            session.onBytes(bytes, timeS)
            newest = session.estimate
            System.nanoTime() - start
        }
    }

private fun report(what: String, nanos: List<Long>) {
    val sorted = nanos.sorted()
    println(
        "%-22s median %.4f ms, 99 %% below %.4f ms".format(
            what, sorted[sorted.size / 2] / 1e6, sorted[sorted.size * 99 / 100] / 1e6,
        ),
    )
}
